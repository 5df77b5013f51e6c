package org.dronewatch.run.advice;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Quantity;

/** The greatest value of one quantity along a flight, where it exceeds its limit. */
final class GreatestExcess {
    /** Flights that use a limit to the full may exceed it by rounding. */
    private static final double ROUNDING = 1.0 + 1e-6;

    private final String verb;
    private final Quantity quantity;
    private final double limit;
    private double greatest;
    private String place = "";

    /**
     * A limit that holds so far.
     *
     * @param verb what the drone does with the quantity, such as {@code climbs at}
     * @param limit the limit, in the quantity's SI unit
     */
    GreatestExcess(String verb, Quantity quantity, double limit) {
        this.verb = verb;
        this.quantity = quantity;
        this.limit = limit;
        this.greatest = limit * ROUNDING;
    }

    /** Takes a value into account. */
    void take(double value, double time, Position at) {
        if (value > greatest) {
            greatest = value;
            place = String.format(
                    Locale.ROOT, ", %.1f s after the start, at (%.1f, %.1f, %.1f) m", time, at.x(), at.y(), at.z());
        }
    }

    /** The excess in words, if there is one. */
    Optional<String> line() {
        return place.isEmpty()
                ? Optional.empty()
                : Optional.of(verb + " " + inWords(greatest) + place + ": its performance allows " + inWords(limit));
    }

    private String inWords(double value) {
        return (quantity.inBrief(value) + " " + quantity.displayUnit()).strip();
    }
}
