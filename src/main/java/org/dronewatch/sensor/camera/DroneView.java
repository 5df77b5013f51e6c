package org.dronewatch.sensor.camera;

import org.dronewatch.sensor.optics.Lens;
import org.dronewatch.world.Light;

/**
 * What a camera sees of a drone in one frame.
 *
 * @param pixels how many pixels show it
 * @param range distance to its origin, m
 * @param focalLength focal length in pixels: the width in pixels of what is 1 m wide at 1 m distance on the axis
 * @param crossing how fast it crosses the image, pixels per second
 * @param light by which it is seen
 * @param sunAngle angle between the lines of sight to the drone and to the sun, rad; infinite when the sun is not
 *     visible
 * @param lens of the camera
 * @param background how far behind its origin, in the line of sight, the ground or a building is, m; infinite for the
 *     sky
 */
public record DroneView(
        int pixels,
        double range,
        double focalLength,
        double crossing,
        Light light,
        double sunAngle,
        Lens lens,
        double background) {

    /** A view before the sky, of green light through a lens that does not blur. */
    public DroneView(int pixels, double range, double focalLength, double crossing, Light light, double sunAngle) {
        this(pixels, range, focalLength, crossing, light, sunAngle, Lens.perfect(Lens.GREEN), Double.POSITIVE_INFINITY);
    }
}
