package inspection;

import models.AffineTransformation;
import tracer.Hit;
import tracer.Ray;

/**
 * A ray and its hit in the frame of a transformed object.
 *
 * @param transformation the transformation from that frame outwards
 * @param ray the ray there, of unit direction
 * @param hit what it hit there, in numbers of that frame
 */
public record LocalRay(AffineTransformation transformation, Ray ray, Hit hit) {
}
