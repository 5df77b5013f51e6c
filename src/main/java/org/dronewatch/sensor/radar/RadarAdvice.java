package org.dronewatch.sensor.radar;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;

/** Warnings about settings of a radar that contradict each other. */
final class RadarAdvice {
    private RadarAdvice() {}

    /** One sentence for each contradiction; none for a radar that can be built. */
    static List<String> on(RadarSettings radar) {
        if (!(radar.budget() instanceof Hardware hardware)) {
            return List.of();
        }
        return Stream.concat(gain(radar, hardware).stream(), scan(radar, hardware).stream())
                .toList();
    }

    private static Optional<String> gain(RadarSettings radar, Hardware hardware) {
        return radar.beam()
                .filter(one -> hardware.gain() > one.largestGain())
                .map(one -> String.format(
                        "an antenna of %s dBi cannot have a beam of %s x %s deg: its gain is at most %s dBi",
                        rounded(hardware.gain()),
                        rounded(Math.toDegrees(one.azimuthBeamwidth())),
                        rounded(Math.toDegrees(one.elevationBeamwidth())),
                        rounded(one.largestGain())));
    }

    private static Optional<String> scan(RadarSettings radar, Hardware hardware) {
        long beams = (long) radar.cells().beams(hardware);
        double scan = beams * hardware.integrationTime();
        if (scan * radar.rate() <= 1.0 + 1e-9) {
            return Optional.empty();
        }
        return Optional.of(String.format(
                "%s for %s x %s deg: at an integrationTime of %s s each, a scan takes %s s, not %s s; lower the rate to"
                        + " %s Hz, or the integrationTime to %s s",
                need(radar, hardware, beams),
                rounded(Math.toDegrees(radar.azimuthWidth())),
                rounded(Math.toDegrees(radar.elevationWidth())),
                rounded(hardware.integrationTime()),
                rounded(scan),
                rounded(1.0 / radar.rate()),
                rounded(1.0 / scan),
                rounded(1.0 / (radar.rate() * beams))));
    }

    private static String need(RadarSettings radar, Hardware hardware, long beams) {
        return radar.beam()
                .map(one -> String.format(
                        "a beam of %s x %s deg needs %d position%s",
                        rounded(Math.toDegrees(one.azimuthBeamwidth())),
                        rounded(Math.toDegrees(one.elevationBeamwidth())),
                        beams,
                        beams == 1 ? "" : "s"))
                .orElseGet(() -> String.format(
                        "an antenna of %s dBi needs at least %d beams",
                        rounded(ResolutionCells.narrowerGain(hardware)), beams));
    }

    /** Three digits, rounded down, so that what is advised is enough. */
    private static String rounded(double value) {
        return new BigDecimal(value * (1.0 + 1e-12))
                .round(new MathContext(3, RoundingMode.DOWN))
                .stripTrailingZeros()
                .toPlainString();
    }
}
