package org.dronewatch.sensor.radar;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection.FixedThreshold;
import org.dronewatch.setting.AdvisedLimit;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.Quantity;

/** Warnings about settings of a radar that contradict each other. */
final class RadarAdvice {
    /**
     * The amount by which a threshold may differ from that implied by a data sheet, dB: half a percent of the range.
     */
    private static final double TOLERANCE = 0.1;

    private RadarAdvice() {}

    /** One sentence for each contradiction; none for a radar that can be built, or of which too little is stated. */
    static List<String> on(RadarSettings radar) {
        return Stream.of(gain(radar), scan(radar), threshold(radar))
                .flatMap(Optional::stream)
                .toList();
    }

    private static Optional<String> gain(RadarSettings radar) {
        double gain = statedGain(radar.budget()).orElse(Double.NEGATIVE_INFINITY);
        return radar.beam()
                .filter(one -> gain > one.largestGain())
                .map(one -> String.format(
                        "an antenna of %s dBi cannot have a beam of %s, whose gain is at most %s dBi",
                        Quantity.LEVEL.inBrief(gain),
                        degrees(one.azimuthBeamwidth(), one.elevationBeamwidth()),
                        AdvisedLimit.inWords(one.largestGain())));
    }

    /** The gain of the transmitting antenna, dBi. */
    private static OptionalDouble statedGain(LinkBudget budget) {
        return budget instanceof Hardware hardware ? OptionalDouble.of(hardware.gain()) : budget.lowerGain();
    }

    /**
     * The warning about a scan that is too fast for its beams: the beam must dwell in each position for all pulses,
     * each of which takes a whole integration time.
     */
    private static Optional<String> scan(RadarSettings radar) {
        OptionalDouble positions = radar.cells().beams(radar.budget().lowerGain());
        OptionalDouble integration = radar.budget().dwell();
        if (positions.isEmpty() || integration.isEmpty()) {
            return Optional.empty();
        }
        long beams = (long) positions.getAsDouble();
        double scan = beams * radar.detection().pulses() * integration.getAsDouble();
        return scan * radar.rate() <= 1.0 + 1e-9 ? Optional.empty() : Optional.of(tooLong(radar, beams, scan));
    }

    private static String tooLong(RadarSettings radar, long beams, double scan) {
        int pulses = radar.detection().pulses();
        return String.format(
                "%s to cover %s: at %san integrationTime of %s s each, a scan takes %s s, not %s s; lower the rate to %s Hz,"
                        + " %sor the integrationTime to %s s",
                need(radar, beams),
                degrees(radar.azimuthWidth(), radar.elevationWidth()),
                pulses == 1 ? "" : pulses + " pulses with ",
                Quantity.DURATION.inBrief(scan / (beams * pulses)),
                Quantity.DURATION.inBrief(scan),
                Quantity.DURATION.inBrief(1.0 / radar.rate()),
                AdvisedLimit.inWords(1.0 / scan),
                pulses == 1 ? "" : "the number of pulses, ",
                AdvisedLimit.inWords(1.0 / (radar.rate() * beams * pulses)));
    }

    private static String need(RadarSettings radar, long beams) {
        return radar.beam()
                .map(one -> String.format(
                        "a beam of %s needs %s",
                        degrees(one.azimuthBeamwidth(), one.elevationBeamwidth()), Counted.of(beams, "position")))
                .orElseGet(() -> String.format(
                        "an antenna of %s dBi needs at least %s",
                        Quantity.LEVEL.inBrief(radar.budget().lowerGain().orElseThrow()), Counted.of(beams, "beam")));
    }

    /**
     * The warning about a fixed threshold that does not give the range of the data sheet: that range holds for the data
     * sheet's probability of detection, whatever the threshold.
     */
    private static Optional<String> threshold(RadarSettings radar) {
        if (!(radar.budget() instanceof DataSheet sheet) || !(radar.detection() instanceof FixedThreshold fixed)) {
            return Optional.empty();
        }
        double excess = fixed.on(sheet.fluctuation()).evenThreshold() - sheet.required(fixed.pulses());
        double reached = sheet.range() * Math.pow(10.0, -excess / 40.0);
        boolean isCutOff = Math.min(reached, sheet.range()) >= radar.maxRange();
        if (Math.abs(excess) <= TOLERANCE || isCutOff) {
            return Optional.empty();
        }
        return Optional.of(String.format(
                Locale.ROOT,
                "with a fixed threshold of %s dB, the target of the data sheet is detected up to %s m, not %s m; a"
                        + " 'signalToNoise' of %.2f dB or 'detection: {kind: chance, falseAlarm: %s}' gives the range of the"
                        + " data sheet",
                Quantity.LEVEL.inBrief(fixed.signalToNoise()),
                Quantity.LENGTH.inBrief(reached),
                Quantity.LENGTH.inBrief(sheet.range()),
                fixed.signalToNoise() - excess,
                sheet.falseAlarm()));
    }

    private static String degrees(double azimuth, double elevation) {
        return Quantity.ANGLE.inBrief(azimuth) + " x " + Quantity.ANGLE.inBrief(elevation) + " deg";
    }
}
