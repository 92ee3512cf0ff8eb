package inspection;

import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A ray and its hit in the frame of an object that is transformed.
 *
 * @param transformation the object that leads from that frame to the surrounding one
 * @param ray the ray in that frame, with unit direction
 * @param hit the hit in that frame
 */
public record LocalRay(Object3D transformation, Ray ray, Hit hit) {
}
