package org.dronewatch.sensor.camera;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.ImageSpeed;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;

/** The signal of a camera in a world, from the number of pixels that show a drone. Not thread-safe. */
final class CameraSignal {
    private final CameraSettings settings;
    private final Beyond beyond;

    /** The light by which the camera sees, dimmed by rain. */
    private final Light light;

    /** The vector to the sun; empty if the camera does not see the sun. */
    private final Optional<Position> sun;

    // The position of the last query, and the distance of the background behind a drone there.
    private Position before;
    private double background;

    CameraSignal(CameraSettings settings, World world) {
        this.settings = settings;
        this.beyond = new Beyond(world, settings.position());
        this.light = world.light().inRain(world.rain());
        this.sun = beyond.sun();
    }

    /** Whether signals depend on nothing but the number of pixels. */
    boolean countPixelsOnly() {
        return settings.detection().countsPixelsOnly();
    }

    /**
     * The view of a drone.
     *
     * @param at position of its origin, m
     * @param velocity its velocity, m/s
     * @param pixels number of pixels that show it
     * @param pointing where a positioner points the camera
     * @param focalLength focal length of the camera as it is pointed, pixels
     */
    DroneView view(Position at, Position velocity, int pixels, Optional<Pointing> pointing, double focalLength) {
        double range = at.distance(settings.position());
        if (pixels == 0 || settings.detection().countsPixelsOnly()) {
            return new DroneView(pixels, range, focalLength, 0.0, light, Double.POSITIVE_INFINITY);
        }
        Position vector = at.minus(settings.position());
        double crossing = ImageSpeed.turning(settings.position(), at, velocity, pointing) * focalLength;
        double sunAngle = sun.map(vector::angle).orElse(Double.POSITIVE_INFINITY);
        return new DroneView(pixels, range, focalLength, crossing, light, sunAngle, settings.lens(), background(at));
    }

    private double background(Position at) {
        if (!at.equals(before)) {
            before = at;
            background = beyond.background(at);
        }
        return background;
    }

    /** The signal of a view. */
    Signal of(DroneView view) {
        DetectionFunction detection = settings.detection();
        double value = detection.value(view);
        return detection.byChance()
                ? Signal.of(detection.probability(view).orElseThrow(), value, detection.unit(), detection.threshold())
                : Signal.certain(value, detection.unit(), detection.threshold());
    }
}
