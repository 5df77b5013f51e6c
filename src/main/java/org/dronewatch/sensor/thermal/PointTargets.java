package org.dronewatch.sensor.thermal;

import java.util.Map;
import org.dronewatch.sensor.NormalTail;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.setting.AdvisedLimit;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Detection, by a program, of drones that are no more than spots: in each frame, the program marks the pixels whose
 * signal exceeds t times the noise, and it reports a spot that was marked in several of the latest frames. Noise is
 * normally distributed, and independent between pixels and between frames, so a frame marks a spot with the probability
 * {@code P1 = Phi(SNR - t)}, where Phi is the normal distribution function and SNR is the ratio, not in dB, of the
 * signal of the spot's pixel to the standard deviation of the noise. At least M of N frames mark it with the
 * probability {@code P = sum over i from M to N of C(N, i) P1^i (1 - P1)^(N - i)}, where C is the binomial coefficient.
 *
 * <p>The threshold t follows from the accepted number of false alarms per hour. In each pixel and frame, noise causes a
 * mean number of false alarms of
 *
 * <pre>
 * C(N - 1, M - 1) p q^(M - 1) (1 - q)^(N - M + 1),  p = Q(t),  q = 1 - (1 - p)^g
 * </pre>
 *
 * <p>where Q is the tail of the normal distribution and g the number of pixels in which the program looks for the same
 * spot in another frame. A spot counts when it is confirmed for the first time: M - 1 of the N - 1 preceding frames had
 * marked it, and the frame before those had not. Two spots that share a mark count twice, so the number is an upper
 * bound if g is more than 1. Twice the frame rate causes twice as many false alarms, and so requires a higher
 * threshold.
 *
 * <p>The frame rate is that of the program. The camera's {@code rate}, at which a run checks what the program has
 * found, changes neither the threshold nor what is found. A look detects a drone if the program has confirmed it in any
 * frame since the previous look.
 *
 * @param falseAlarmsPerHour accepted number of false alarms per hour that noise causes, 1e-6 to 1e9, which the camera
 *     also raises in a run unless {@code falseAlarms} gives the rate for all causes. The highest threshold that causes
 *     this number is used or, if there is none, the one that causes the most
 * @param hits M, the minimum number of the latest N frames that must mark a spot, 1 to 50
 * @param frames N, number of the latest frames that are considered, from hits to 50
 * @param gate g, number of pixels in which the spot is searched for in the next frame, 1 to 10,000: 9 for a drone that
 *     moves by at most one pixel per frame
 * @param frameRate frames that the program examines per second, above 0, Hz; at most 1000 per look
 */
public record PointTargets(
        @In(value = Quantity.NUMBER, from = 1e-6, to = 1e9) double falseAlarmsPerHour,
        @In(value = Quantity.NUMBER, from = 1, to = 50) int hits,
        @In(value = Quantity.NUMBER, from = 1, to = 50) int frames,
        @In(value = Quantity.PIXELS, from = 1, to = 10_000) int gate,
        @In(value = Quantity.FREQUENCY, above = 0, to = 10_000) double frameRate) {
    /** One false alarm per hour, three of five frames, a gate of 3 x 3 pixels, 25 frames per second. */
    @Defaults
    public static final PointTargets DEFAULT = new PointTargets(1.0, 3, 5, 9, 25.0);

    /** Nothing of interest lies farther out than this, in standard deviations: the normal tail is 1e-315 there. */
    private static final double FARTHEST = 38.0;

    /** Rounding must not make a whole number of looks one look longer. */
    private static final double ROUNDING = 1e-9;

    private static final double SECONDS_PER_HOUR = 3600.0;

    /** The greatest number of frames between two looks. */
    private static final double MOST_FRAMES = 1000.0;

    /** Logarithm of a probability so low that nothing is ever marked. */
    private static final double LOWEST = -700.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public PointTargets {
        Limits.check(PointTargets.class, falseAlarmsPerHour, hits, frames, gate, frameRate);
        if (hits > frames) {
            throw new IllegalArgumentException("hits " + hits + " must be at most frames " + frames);
        }
    }

    /** These settings with another number of false alarms per hour. */
    public PointTargets withFalseAlarmsPerHour(double accepted) {
        return SettingsForm.with(this, "falseAlarmsPerHour", accepted);
    }

    /** These settings with another rule for confirmation: hits M and frames N. */
    public PointTargets withConfirmation(int ofFrames, int inFrames) {
        return SettingsForm.with(this, Map.of("hits", ofFrames, "frames", inFrames));
    }

    /** These settings with another gate, pixels. */
    public PointTargets withGate(int pixels) {
        return SettingsForm.with(this, "gate", pixels);
    }

    /** These settings with another number of frames per second, Hz. */
    public PointTargets withFrameRate(double perSecond) {
        return SettingsForm.with(this, "frameRate", perSecond);
    }

    /**
     * The threshold t, in standard deviations of the noise, at which the number of false alarms is the accepted one.
     *
     * @param pixels number of pixels of the image
     */
    public double threshold(long pixels) {
        double accepted = falseAlarmsPerHour / (SECONDS_PER_HOUR * frameRate * pixels);
        double most = mostConfirmed();
        double mark = confirmations(most) <= accepted
                ? most
                : Math.exp(Bisection.root(LOWEST, Math.log(most), x -> accepted - confirmations(Math.exp(x))));
        return exceededWith(mark);
    }

    /**
     * The probability of a mark at which noise is confirmed most often; at a higher probability, spots no longer come
     * to an end. The derivative of the logarithm of the frequency of confirmations decreases everywhere, so it has one
     * zero.
     */
    private double mostConfirmed() {
        return Bisection.root(
                0.0,
                1.0,
                p -> 1.0 / p
                        + (hits - 1) * gate * Math.pow(1.0 - p, gate - 1) / marks(p)
                        - (double) gate * (frames - hits + 1) / (1.0 - p));
    }

    /**
     * The number of false alarms per hour that noise causes.
     *
     * @param threshold t, in standard deviations of the noise
     * @param pixels number of pixels of the image
     */
    public double falseAlarmsPerHour(double threshold, long pixels) {
        return SECONDS_PER_HOUR * frameRate * pixels * confirmations(NormalTail.above(threshold));
    }

    /**
     * The rate of false alarms that noise causes. Each false alarm is taken to last as long as its marks can keep it
     * confirmed, N - M + 1 frames, and to be distinct from any other that lies outside its gate.
     *
     * @param pixels number of pixels of the image
     * @param looks per second, Hz
     */
    FalseAlarmRate rate(long pixels, double looks) {
        double perHour = falseAlarmsPerHour(threshold(pixels), pixels);
        int longest = longest(looks);
        // The rounding of the threshold must not turn the accepted number into too high a number.
        double perLook =
                Math.min(perHour / (SECONDS_PER_HOUR * looks), Math.nextDown(FalseAlarmRate.MOST_PER_LOOK / longest));
        return new FalseAlarmRate(perLook, Math.max(1, pixels / gate), longest, looks);
    }

    /** The greatest number of looks for which noise stays confirmed. */
    private int longest(double looks) {
        return (int) Math.max(1.0, Math.ceil((frames - hits + 1) * looks / frameRate - ROUNDING));
    }

    /**
     * Checks that a look does not span more frames than can be simulated.
     *
     * @param looks per second, Hz
     * @throws IllegalArgumentException when it spans more than a thousand
     */
    void checkFrames(double looks) {
        if (frameRate > MOST_FRAMES * looks) {
            throw new IllegalArgumentException("pointTargets.frameRate " + Quantity.FREQUENCY.inWords(frameRate)
                    + " with a rate of " + Quantity.FREQUENCY.inWords(looks) + " must be at most "
                    + AdvisedLimit.inWords(MOST_FRAMES * looks) + " Hz: "
                    + (int) MOST_FRAMES + " frames in a look");
        }
    }

    /**
     * Checks that no more false alarms are accepted than can be simulated.
     *
     * @param looks per second, Hz
     * @throws IllegalArgumentException when more than {@link FalseAlarmRate#MOST_PER_LOOK} would be expected in a look
     */
    void checkRate(double looks) {
        double most = FalseAlarmRate.MOST_PER_LOOK * SECONDS_PER_HOUR * looks / longest(looks);
        if (falseAlarmsPerHour > most) {
            throw new IllegalArgumentException("pointTargets.falseAlarmsPerHour "
                    + Quantity.NUMBER.inWords(falseAlarmsPerHour) + " at " + Quantity.NUMBER.inWords(looks)
                    + " looks a second must be at most " + AdvisedLimit.inWords(most) + ": "
                    + (int) FalseAlarmRate.MOST_PER_LOOK + " at the same time");
        }
    }

    /**
     * The mean number of times that noise is confirmed in one pixel and frame, if it marks a pixel with a probability
     * p.
     */
    private double confirmations(double p) {
        double q = marks(p);
        return combinations(frames - 1, hits - 1) * p * Math.pow(q, hits - 1) * Math.pow(1.0 - q, frames - hits + 1);
    }

    /** The probability that noise marks a pixel of the gate. */
    private double marks(double p) {
        return -Math.expm1(gate * Math.log1p(-p));
    }

    /**
     * The t that a standard normal variable exceeds with a given probability.
     *
     * @param probability 1e-300 to 1 - 1e-15
     */
    static double exceededWith(double probability) {
        return Bisection.root(-FARTHEST, FARTHEST, t -> NormalTail.above(t) - probability);
    }

    /**
     * The probability that one frame marks a spot: {@code Phi(SNR - t)}.
     *
     * @param signalToNoise SNR, the ratio, not in dB, of the signal of the pixel that contains the spot to the standard
     *     deviation of the noise, 0 or more
     * @param threshold t, in standard deviations of the noise
     */
    public static double markProbability(double signalToNoise, double threshold) {
        return NormalTail.above(threshold - signalToNoise);
    }

    /**
     * The probability that at least M of N frames mark a spot.
     *
     * @param mark probability P1 that one frame marks the spot, 0 to 1
     */
    public double probability(double mark) {
        double sum = 0.0;
        for (int i = hits; i <= frames; i++) {
            sum += combinations(frames, i) * Math.pow(mark, i) * Math.pow(1.0 - mark, frames - i);
        }
        return Math.min(1.0, sum);
    }

    static double combinations(int of, int chosen) {
        double product = 1.0;
        for (int i = 1; i <= chosen; i++) {
            product *= (double) (of - chosen + i) / i;
        }
        return Math.rint(product);
    }
}
