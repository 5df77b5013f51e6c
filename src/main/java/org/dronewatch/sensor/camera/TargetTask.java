package org.dronewatch.sensor.camera;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.optics.ImageTransfer;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.Light;

/**
 * A detection function that is based on the probability that a person, or a program that performs equally well, can
 * perform a task with a drone's image: detect it, recognise it as a drone, or identify its type. Johnson's criteria
 * state the number of line pairs across the target that each task requires (Johnson 1958); the target transfer
 * probability function gives the probability for more or fewer (Howe, in "The Infrared and Electro-Optical Systems
 * Handbook", vol. 4, 1993): {@code P = x^E / (1 + x^E)} with {@code x = N / N50} and {@code E = 2.7 + 0.7 x}, where N
 * is the number of line pairs resolved across the target and N50 the number at which the probability is 0.5.
 *
 * <p>The number of line pairs resolved is half the square root of the number of the drone's pixels, and lower if the
 * drone's contrast is weak or if it crosses the image fast: {@code N = sqrt(pixels) / 2 * u * (1 + b^2)^(-1/4)}. The
 * highest spatial frequency that is resolved, as a fraction u of the Nyquist frequency of the pixels, is the one at
 * which the contrast after lens and air, {@code C M(u)}, falls to the contrast that the camera requires,
 * {@code Ct / (1 - u)} ({@link org.dronewatch.sensor.optics.ImageTransfer#resolved}); without blur,
 * {@code u = 1 - Ct / C}. C is the drone's contrast, reduced by air and rain (Koschmieder against the sky, Duntley
 * against the ground), and M is the modulation transfer of lens and air. Ct is the least contrast that the camera can
 * detect; in poor light, where photons are few, it grows as the square root of the ratio of
 * {@code shotNoiseIlluminance} to the actual illuminance. b is the motion blur in pixels, along one of the two
 * dimensions of the image. The dependence on contrast is a straight line instead of a camera's measured curve of
 * minimum resolvable contrast.
 *
 * @param task the task that the image must support
 * @param probability probability at and above which the task counts as accomplished, above 0 and below 1; not used with
 *     {@code byChance}
 * @param byChance whether detection is random instead: one draw per encounter determines whether the observer can
 *     perform the task at all, and a capable observer then needs time to find the drone
 * @param contrast contrast of the drone against the sky at close range, above 0 and at most 1: the drone is darker by
 *     this fraction
 * @param groundContrast contrast of the drone against a background other than the sky, above 0 and at most 100; omit it
 *     to derive it from {@code contrast} and {@code world.light.skyToGroundRatio}
 * @param contrastThreshold minimum contrast that the camera can detect in good light, above 0 and below 1
 * @param shotNoiseIlluminance illuminance below which shot noise raises the contrast threshold, above 0, lx
 * @param exposure exposure time of a frame, 0 to 1 s
 * @param sunExclusionAngle angle around the sun within which drones cannot be seen, 0 to pi/2, rad
 */
public record TargetTask(
        Discrimination task,
        @In(value = Quantity.RATIO, above = 0, below = 1) double probability,
        boolean byChance,
        @In(value = Quantity.RATIO, above = 0, to = 1) double contrast,
        @In(value = Quantity.RATIO, above = 0, to = 100) Optional<Double> groundContrast,
        @In(value = Quantity.RATIO, above = 0, below = 1) @Formerly("leastContrast") double contrastThreshold,
        @In(value = Quantity.ILLUMINANCE, above = 0, to = 200_000) @Formerly("goodLight") double shotNoiseIlluminance,
        @In(value = Quantity.DURATION, from = 0, to = 1) double exposure,
        @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 2) @Formerly("glare") double sunExclusionAngle)
        implements DetectionFunction {
    /**
     * Detection at a probability of 0.5, of a drone of contrast 0.5, by a camera that detects a contrast of 2 % down to
     * 100 lx, has an exposure time of 0.01 s, and is blind within 5 degrees of the sun. All values are assumed except
     * the task.
     */
    @Defaults
    public static final TargetTask DEFAULT = new TargetTask(
            Discrimination.DETECTION, 0.5, false, 0.5, Optional.empty(), 0.02, 100.0, 0.01, Math.toRadians(5.0));

    private static final double EVEN_CHANCE = 0.5;

    /** Checks the limits. */
    public TargetTask {
        Limits.check(
                TargetTask.class,
                task,
                probability,
                byChance,
                contrast,
                groundContrast,
                contrastThreshold,
                shotNoiseIlluminance,
                exposure,
                sunExclusionAngle);
    }

    /** These settings for another task. */
    public TargetTask withTask(Discrimination other) {
        return SettingsForm.with(this, "task", other);
    }

    /** These settings with another probability at and above which the task counts as accomplished. */
    public TargetTask withProbability(double least) {
        return SettingsForm.with(this, "probability", least);
    }

    /** These settings with {@code byChance} set or not. */
    public TargetTask withChance(boolean drawn) {
        return SettingsForm.with(this, "byChance", drawn);
    }

    /** These settings for a drone with another contrast. */
    public TargetTask withContrast(double ofDrone) {
        return SettingsForm.with(this, "contrast", ofDrone);
    }

    /** These settings with a stated contrast of the drone against a background other than the sky. */
    public TargetTask withGroundContrast(double ofDrone) {
        return SettingsForm.with(this, "groundContrast", Optional.of(ofDrone));
    }

    /** These settings with another exposure time, s. */
    public TargetTask withExposure(double seconds) {
        return SettingsForm.with(this, "exposure", seconds);
    }

    /** The number N of line pairs resolved across a drone. */
    public double resolved(DroneView view) {
        if (view.sunAngle() < sunExclusionAngle) {
            return 0.0;
        }
        double seen = contrastSeen(view);
        double needed = contrastThreshold
                * Math.sqrt(Math.max(1.0, shotNoiseIlluminance / view.light().illuminance()));
        double finest = ImageTransfer.through(view.lens(), view.light().cn2(), view.range())
                .resolved(needed, seen, view.focalLength());
        double blur = view.crossing() * exposure;
        return 0.5 * Math.sqrt(view.pixels()) * finest / Math.sqrt(Math.sqrt(1.0 + blur * blur));
    }

    /** The contrast of a drone at the camera. */
    private double contrastSeen(DroneView view) {
        Light light = view.light();
        double brightness = light.backgroundBrightness(view.background());
        return contrastAgainst(brightness, view.background()) * light.contrastLeft(view.range(), brightness);
    }

    /** The contrast of a drone at close range against a background that is darker or brighter than the sky. */
    private double contrastAgainst(double brightness, double behind) {
        if (groundContrast.isPresent() && behind < Double.POSITIVE_INFINITY) {
            return groundContrast.get();
        }
        return brightness == 1.0 ? contrast : Math.abs(1.0 - contrast - brightness) / brightness;
    }

    @Override
    public double value(DroneView view) {
        return task.probability(resolved(view));
    }

    @Override
    public double threshold() {
        return byChance ? EVEN_CHANCE : probability;
    }

    /**
     * {@inheritDoc} With {@code byChance}, once per encounter: an observer either can perform the task or cannot, and
     * needs time for it.
     */
    @Override
    public Chance chance() {
        return byChance ? Chance.PER_ENCOUNTER : Chance.PER_LOOK;
    }

    @Override
    public OptionalDouble probability(DroneView view) {
        return OptionalDouble.of(value(view));
    }

    /**
     * {@inheritDoc} The value is the probability of detection: a detected drone can be followed, even if it cannot be
     * recognised or identified yet.
     */
    @Override
    public OptionalDouble followingValue(DroneView view) {
        return OptionalDouble.of(Discrimination.DETECTION.probability(resolved(view)));
    }

    @Override
    public boolean growsWithPixels() {
        return true;
    }

    @Override
    public String unit() {
        return Quantity.RATIO.unit();
    }
}
