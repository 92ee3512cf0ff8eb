package inspection;

import models.AffineTransformation;
import tracer.Hit;
import tracer.Ray;

/**
 * A ray and its hit in the frame of a transformed object.
 *
 * @param transformation the transformation from that frame to the surrounding one
 * @param ray the ray in that frame, with unit direction
 * @param hit the hit in that frame
 */
public record LocalRay(AffineTransformation transformation, Ray ray, Hit hit) {
}
