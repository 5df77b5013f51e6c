package org.dronewatch.sensor.optics;

import java.util.Optional;
import org.dronewatch.sensor.positioner.Direction;
import org.dronewatch.sensor.positioner.Positioner;
import org.dronewatch.sensor.positioner.PositionerSettings;
import org.dronewatch.sensor.positioner.ZoomSettings;

/** Mounts that turn, under cameras of any kind. */
public final class Mounts {
    private Mounts() {}

    /**
     * Checks that a mount's lens zooms in, not out.
     *
     * @param fov the camera's own field of view, rad
     * @throws IllegalArgumentException when it does not
     */
    public static void check(double fov, Optional<PositionerSettings> mount) {
        mount.flatMap(PositionerSettings::zoom).ifPresent(lens -> check(fov, lens));
    }

    private static void check(double fov, ZoomSettings lens) {
        double widest = Math.max(lens.cued(), lens.tracked());
        if (widest > fov) {
            throw new IllegalArgumentException("zoom to " + (float) widest
                    + " rad must be at most the camera's own field of view, fov " + (float) fov + " rad");
        }
    }

    /** The mount of a camera at the start of a run, if it has one. */
    public static Optional<Positioner> create(PictureSettings camera, Optional<PositionerSettings> mount) {
        return mount.map(settings -> new Positioner(
                settings, camera.position(), Direction.of(camera.aim().from(camera.position())), camera.fov()));
    }
}
