package org.dronewatch.sensor.camera;

import org.dronewatch.world.Light;

/**
 * What a camera has of a drone in one frame.
 *
 * @param pixels how many pixels show it
 * @param range distance to its origin, m
 * @param focalLength focal length in pixels: what is 1 m wide at 1 m distance on the axis covers so many
 * @param crossing how fast it goes across the picture, pixels a second
 * @param light by which it is seen
 * @param sunAngle angle between the ways to the drone and to the sun, rad; infinite when the sun is not to be seen
 */
public record DroneView(int pixels, double range, double focalLength, double crossing, Light light, double sunAngle) {}
