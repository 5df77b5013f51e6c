package org.dronewatch.app.search;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Rounds in which layouts are compared on all known routes, and the routes past them are flown, until flights show no
 * other routes that matter. If they are asked to end between two rounds, layouts are compared once more, on all routes
 * known by then.
 *
 * @param most greatest number of rounds, 1 or more
 * @param isEnding queried before each round
 */
record ComparisonRounds(int most, BooleanSupplier isEnding) {
    /** A round. */
    interface Round<T> {
        /**
         * Compares layouts, and flies the routes past them.
         *
         * @param isLast whether no other round follows
         * @return the result; empty if another round is needed, but never in the last one
         */
        Optional<T> result(boolean isLast);
    }

    /** The result of the last round. */
    <T> T result(Round<T> round) {
        for (int number = 1; number < most && !isEnding.getAsBoolean(); number++) {
            Optional<T> result = round.result(false);
            if (result.isPresent()) {
                return result.get();
            }
        }
        return round.result(true).orElseThrow();
    }
}
