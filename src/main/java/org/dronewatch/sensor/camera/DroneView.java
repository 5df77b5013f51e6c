package org.dronewatch.sensor.camera;

/**
 * What a camera has of a drone in one frame.
 *
 * @param pixels how many pixels show it
 * @param range distance to its origin, m
 * @param focalLength focal length in pixels: what is 1 m wide at 1 m distance on the axis covers so many
 */
public record DroneView(int pixels, double range, double focalLength) {}
