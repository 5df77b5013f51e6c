package org.dronewatch.sensor.thermal;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.ImageSpeed;
import org.dronewatch.sensor.optics.ImageTransfer;
import org.dronewatch.setting.Quantity;

/**
 * The signal of a thermal camera, from the area of a drone in its image.
 *
 * @param settings settings of the camera
 * @param spots the program that finds spots, if there is one
 * @param pointing where a positioner points the camera
 * @param focalLength focal length of the camera as it is pointed, pixels
 * @param cn2 turbulence of the air, m^(-2/3)
 */
record ThermalSignal(
        ThermalSettings settings,
        Optional<SpotDetector> spots,
        Optional<Pointing> pointing,
        double focalLength,
        double cn2) {
    private static final double KILOMETRE = 1000.0;
    private static final double EVEN_CHANCE = 0.5;

    /** The signal of a drone with a given area in the image, pixels. */
    Signal of(Drone drone, double pixels) {
        return of(drone, pixels, turning(drone));
    }

    /** The signal that a drone would have if it did not move in the image: never weaker than if it moves. */
    Signal atRest(Drone drone, double pixels) {
        return of(drone, pixels, 0.0);
    }

    private Signal of(Drone drone, double pixels, double turning) {
        double ratio = toNoise(drone, pixels);
        double probability = spots.map(detector -> detector.probability(ratio))
                .orElseGet(() -> settings.task().probability(resolved(drone, pixels, ratio, turning)));
        double ofALook =
                spots.map(detector -> detector.probabilityOfALook(ratio)).orElse(probability);
        return settings.byChance()
                ? Signal.of(ofALook, probability, Quantity.RATIO.unit(), EVEN_CHANCE)
                : Signal.certain(probability, Quantity.RATIO.unit(), settings.probability());
    }

    /** Signal-to-noise ratio of a drone: for a spot, that of the pixel that receives most of its heat. */
    double toNoise(Drone drone, double pixels) {
        double range = drone.distance(settings.position());
        double received = spots.isPresent() ? through(range).ensquaredEnergy(focalLength) : 1.0;
        return toNoise(settings, drone.heat(), range, received * pixels);
    }

    private ImageTransfer through(double range) {
        return ImageTransfer.through(settings.lens(), cn2, range);
    }

    /**
     * Signal-to-noise ratio of a drone.
     *
     * @param excess temperature difference between the drone and its background, K
     * @param range distance of the drone, m
     * @param pixels number of pixels that it covers
     */
    static double toNoise(ThermalSettings camera, double excess, double range, double pixels) {
        double air = Math.pow(camera.transmission(), range / KILOMETRE);
        return Math.abs(excess) * air * Math.min(1.0, pixels) / camera.netd();
    }

    /** The line pairs resolved across a drone. */
    double resolved(Drone drone, double pixels, double signal) {
        return resolved(drone, pixels, signal, turning(drone));
    }

    private double resolved(Drone drone, double pixels, double signal, double turning) {
        double range = drone.distance(settings.position());
        double finest = through(range).resolved(settings.minSnr(), signal, focalLength);
        double blur = finest > 0.0 ? turning * focalLength * settings.exposure() : 0.0;
        return 0.5 * Math.sqrt(pixels) * finest * ImageSpeed.resolutionLeft(blur);
    }

    private double turning(Drone drone) {
        return ImageSpeed.turning(settings.position(), drone, pointing);
    }
}
