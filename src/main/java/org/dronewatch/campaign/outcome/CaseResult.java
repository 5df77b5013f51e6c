package org.dronewatch.campaign.outcome;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of one case with one variant.
 *
 * @param number number of the case, from 0
 * @param variant name of the variant
 * @param seed seed of the run
 * @param values values of the settings that vary, as text, in the order of the campaign
 * @param error why there is no result, in one line; empty if there is one
 * @param bearing bearing of the first attacking drone at the start, from the centre of what is protected or from the
 *     mean position of the sensors, clockwise from north, rad; empty in a case that failed or has no drone
 * @param firstDetected when an attacking drone was first detected by any sensor, s; empty if never
 * @param firstSensor the sensor that made this first detection; empty if there was none
 * @param range distance of the drone from the sensor at the first detection, m; empty if there was none
 * @param alert when the first alert was raised for an attacking drone, s; empty if never
 * @param warning the warning time of that alert, s; empty if there is no alert or no zone
 * @param inTime whether that alert came in time, false without an alert; empty if nothing is protected or no response
 *     time is required
 * @param closest the shortest distance of an attacking drone from what is protected, m: 0 if one reached it; empty if
 *     nothing is protected
 * @param cutShort whether the run ended while an attacking drone for which there was no alert was still coming closer
 *     to what is protected: a longer run might have another outcome
 * @param drones the outcome for each attacking drone, by name, in the order of the scene; empty in a case that failed
 */
public record CaseResult(
        int number,
        String variant,
        long seed,
        List<String> values,
        Optional<String> error,
        OptionalDouble bearing,
        OptionalDouble firstDetected,
        Optional<String> firstSensor,
        OptionalDouble range,
        OptionalDouble alert,
        OptionalDouble warning,
        Optional<Boolean> inTime,
        OptionalDouble closest,
        boolean cutShort,
        Map<String, DroneOutcome> drones) {
    /** Copies the list and the map. */
    public CaseResult {
        values = List.copyOf(values);
        drones = Collections.unmodifiableMap(new LinkedHashMap<>(drones));
    }

    /** A case that could not be run. */
    public static CaseResult failed(int number, String variant, long seed, List<String> values, String error) {
        return new CaseResult(
                number,
                variant,
                seed,
                values,
                Optional.of(error),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                false,
                Map.of());
    }

    /** Whether the case has no result. */
    public boolean isFailed() {
        return error.isPresent();
    }

    /** A copy with another reason why there is no result. */
    public CaseResult withError(Optional<String> other) {
        return new CaseResult(
                number,
                variant,
                seed,
                values,
                other,
                bearing,
                firstDetected,
                firstSensor,
                range,
                alert,
                warning,
                inTime,
                closest,
                cutShort,
                drones);
    }
}
