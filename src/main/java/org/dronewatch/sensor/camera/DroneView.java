package org.dronewatch.sensor.camera;

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
 */
public record DroneView(int pixels, double range, double focalLength, double crossing, Light light, double sunAngle) {}
