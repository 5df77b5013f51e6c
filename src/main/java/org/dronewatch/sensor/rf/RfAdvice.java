package org.dronewatch.sensor.rf;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.setting.AdvisedLimit;
import org.dronewatch.setting.Quantity;

/** Warnings about settings of a receiver that contradict each other, or that change nothing. */
final class RfAdvice {
    private static final double MEGAHERTZ = 1e6;

    /** Dwells that fill a look exactly, apart from rounding, fit into it. */
    private static final double ROUNDING = 1e-9;

    private RfAdvice() {}

    /** One sentence for each problem; none for a receiver that can be built. */
    static List<String> on(RfSettings receiver) {
        return Stream.of(noise(receiver), gain(receiver), dwells(receiver))
                .flatMap(Optional::stream)
                .toList();
    }

    /** The warning about an environment whose noise is not known at any frequency that the receiver receives. */
    private static Optional<String> noise(RfSettings receiver) {
        return receiver.environment()
                .filter(noise -> receiver.minFrequency() > noise.highestFrequency())
                .map(noise -> String.format(
                        Locale.ROOT,
                        "environment has no effect: ITU-R P.372 gives its noise only up to %s MHz,"
                                + " less than minFrequency, %s MHz",
                        Quantity.FREQUENCY.inBrief(noise.highestFrequency() / MEGAHERTZ),
                        Quantity.FREQUENCY.inBrief(receiver.minFrequency() / MEGAHERTZ)));
    }

    /**
     * The warning about dwells that overlap those of the next look: each look would hear what another has already
     * heard.
     */
    private static Optional<String> dwells(RfSettings receiver) {
        return receiver.dwell()
                .filter(dwell -> dwell.time() * dwell.count() * receiver.rate() > 1.0 + ROUNDING)
                .map(dwell -> dwell.count() + " x " + Quantity.DURATION.inBrief(dwell.time())
                        + " s of dwell is longer than a look of " + Quantity.DURATION.inBrief(1.0 / receiver.rate())
                        + " s: set a rate of at most " + AdvisedLimit.inWords(1.0 / (dwell.time() * dwell.count()))
                        + " Hz");
    }

    private static Optional<String> gain(RfSettings receiver) {
        return receiver.beam()
                .filter(beam -> receiver.gain() > beam.largestGain())
                .map(beam -> String.format(
                        "an antenna of %s dBi cannot have a beam of %s x %s deg, whose gain is at most %s dBi",
                        Quantity.LEVEL.inBrief(receiver.gain()),
                        Quantity.ANGLE.inBrief(beam.azimuthBeamwidth()),
                        Quantity.ANGLE.inBrief(beam.elevationBeamwidth()),
                        AdvisedLimit.inWords(beam.largestGain())));
    }
}
