/**
 * The program: images, how they are computed from a scene, and the command line.
 *
 * <p>{@link upnatray.Image#synthesis} is the assignment's loop over the pixels, in tiles and on all cores;
 * {@link rendering.RenderSettings} says how (threads, {@link rendering.Shading}, {@link rendering.Progress}).
 *
 * <pre>{@code
 * Group3D scene = new Group3D();
 * scene.addObject(new Sphere(new Point3D(0, 0, 0), 1, Color.ORANGE));
 * Camera camera = new Camera(new Point3D(0, 2, 6), new Point3D(0, 0, 0), new Vector3D(0, 1, 0));
 * camera.setProjection(new Perspective(40, 1.5f));
 * Image image = new Image(600, 400, Color.DARK_GRAY);
 * image.synthesis(scene, camera);
 * int corner = image.getRGB(0, 0);
 * }</pre>
 */
package upnatray;
