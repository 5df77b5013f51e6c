package org.dronewatch.sensor.camera;

import org.dronewatch.sensor.optics.Lens;
import org.dronewatch.world.Light;

/**
 * A camera's view of a drone in one frame.
 *
 * @param pixels number of pixels that show the drone
 * @param range distance from the camera to the drone's origin, m
 * @param focalLength focal length in pixels: the width in pixels of the image of an object 1 m wide at a distance of
 *     1 m on the axis
 * @param crossing speed of the drone across the image, pixels per second
 * @param light light by which the drone is seen
 * @param sunAngle angle between the lines of sight to the drone and to the sun, rad; infinite when the sun is not
 *     visible
 * @param lens lens of the camera
 * @param background distance from the drone's origin, along the line of sight, to the ground or a building behind the
 *     drone, m; infinite for the sky
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

    /** This view with another number of pixels that show the drone. */
    DroneView withPixels(int others) {
        return new DroneView(others, range, focalLength, crossing, light, sunAngle, lens, background);
    }

    /** A view against the sky through a lens without diffraction; turbulence blurs it as it blurs green light. */
    public DroneView(int pixels, double range, double focalLength, double crossing, Light light, double sunAngle) {
        this(pixels, range, focalLength, crossing, light, sunAngle, Lens.perfect(Lens.GREEN), Double.POSITIVE_INFINITY);
    }
}
