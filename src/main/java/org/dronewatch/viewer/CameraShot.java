package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.optics.DronePixels;

/**
 * A camera's view at one time; its arrays are no longer modified.
 *
 * @param background the site in shades of blue, or the site and the drones in colour, with no more pixels than the
 *     panel has
 * @param time seconds since the start of the run
 * @param drones the pixels of each drone, at the camera's own resolution
 * @param pointing where its positioner points at that time; empty for a fixed camera
 * @param inColour whether the background shows what the camera would photograph
 */
record CameraShot(
        BufferedImage background,
        double time,
        List<DronePixels> drones,
        Optional<Pointing> pointing,
        boolean inColour) {}
