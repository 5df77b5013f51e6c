package org.dronewatch.sensor.radar;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;

/** Warnings about settings of a radar that contradict each other. */
final class RadarAdvice {
    private RadarAdvice() {}

    /** One sentence for each contradiction; none for a radar that can be built, or of which too little is stated. */
    static List<String> on(RadarSettings radar) {
        return Stream.concat(gain(radar).stream(), scan(radar).stream()).toList();
    }

    private static Optional<String> gain(RadarSettings radar) {
        double gain = statedGain(radar.budget()).orElse(Double.NEGATIVE_INFINITY);
        return radar.beam()
                .filter(one -> gain > one.largestGain())
                .map(one -> String.format(
                        "an antenna of %s dBi cannot have a beam of %s x %s deg: its gain is at most %s dBi",
                        rounded(gain),
                        rounded(Math.toDegrees(one.azimuthBeamwidth())),
                        rounded(Math.toDegrees(one.elevationBeamwidth())),
                        rounded(one.largestGain())));
    }

    /** That of the transmitting antenna, dBi. */
    private static OptionalDouble statedGain(LinkBudget budget) {
        return budget instanceof Hardware hardware ? OptionalDouble.of(hardware.gain()) : budget.narrowerGain();
    }

    private static Optional<String> scan(RadarSettings radar) {
        OptionalDouble positions = radar.cells().beams(radar.budget().narrowerGain());
        OptionalDouble dwell = radar.budget().dwell();
        if (positions.isEmpty() || dwell.isEmpty()) {
            return Optional.empty();
        }
        long beams = (long) positions.getAsDouble();
        double scan = beams * dwell.getAsDouble();
        if (scan * radar.rate() <= 1.0 + 1e-9) {
            return Optional.empty();
        }
        return Optional.of(String.format(
                "%s for %s x %s deg: at an integrationTime of %s s each, a scan takes %s s, not %s s; lower the rate to"
                        + " %s Hz, or the integrationTime to %s s",
                need(radar, beams),
                rounded(Math.toDegrees(radar.azimuthWidth())),
                rounded(Math.toDegrees(radar.elevationWidth())),
                rounded(dwell.getAsDouble()),
                rounded(scan),
                rounded(1.0 / radar.rate()),
                rounded(1.0 / scan),
                rounded(1.0 / (radar.rate() * beams))));
    }

    private static String need(RadarSettings radar, long beams) {
        return radar.beam()
                .map(one -> String.format(
                        "a beam of %s x %s deg needs %d position%s",
                        rounded(Math.toDegrees(one.azimuthBeamwidth())),
                        rounded(Math.toDegrees(one.elevationBeamwidth())),
                        beams,
                        beams == 1 ? "" : "s"))
                .orElseGet(() -> String.format(
                        "an antenna of %s dBi needs at least %d beams",
                        rounded(radar.budget().narrowerGain().orElseThrow()), beams));
    }

    /** Three digits, rounded down, so that what is advised is enough. */
    private static String rounded(double value) {
        return new BigDecimal(value * (1.0 + 1e-12))
                .round(new MathContext(3, RoundingMode.DOWN))
                .stripTrailingZeros()
                .toPlainString();
    }
}
