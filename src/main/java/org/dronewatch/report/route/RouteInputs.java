package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.scenario.SceneSettings;

/**
 * The inputs of a search for routes, as stated in its result files.
 *
 * @param scene name of the scene
 * @param drone name of the drone
 * @param settings settings of the scene
 * @param protection protected zones of the scene
 * @param grid the cells of the search
 * @param pointing how sensors on positioners point
 * @param launch the area from which the routes come, as it was given; empty for the edge of the area searched
 * @param stopped probability that a response in time stops the drone, 0 to 1; empty if it was not given
 */
public record RouteInputs(
        String scene,
        String drone,
        SceneSettings settings,
        Protection protection,
        FieldGrid grid,
        FieldTerms.Turning pointing,
        Optional<String> launch,
        Optional<Double> stopped) {
    /** Geographic position of the scene's origin, if it is known. */
    Optional<Origin> origin() {
        return settings.world().origin();
    }

    /** Where the sensors are, m. */
    List<Position> sensors() {
        return settings.enabledSensors().values().stream()
                .map(sensor -> sensor.position())
                .toList();
    }

    /**
     * Whether the search counts sensors on positioners as cued. In the flights that check a route, positioners only
     * search, so these flights do not show what cued sensors would detect.
     */
    public boolean isCued() {
        return pointing == FieldTerms.Turning.CUED && RouteProof.hasCues(settings);
    }

    /** The time that a response takes, 0 if none is required, s. */
    double response() {
        return settings.alert().response();
    }

    /** Where the search looks for routes, {@code in cells of 15 m, 10 to 150 m above the ground}. */
    String cellsInWords() {
        return "in cells of " + number(grid.cell()) + " m, " + heightsInWords() + " above the ground";
    }

    /** At which heights above the ground the search looks for routes, {@code 10 to 150 m}. */
    String heightsInWords() {
        String lowest = number(lowest());
        String highest = number(highest());
        return (lowest.equals(highest) ? lowest : lowest + " to " + highest) + " m";
    }

    /** The greatest height above the ground at which the search looks for routes, m. */
    double highest() {
        double most = ceiling();
        return grid.heights().stream().filter(height -> height <= most).reduce(lowest(), Math::max);
    }

    /** The greatest height above the ground at which the drone can fly, m. */
    double ceiling() {
        return settings.individualDrones().get(drone).flightLimits().ceiling();
    }

    /** The least height above the ground at which the search looks for routes, m. */
    double lowest() {
        return grid.heights().get(0);
    }

    /** What the routes lead to. */
    String targetInWords() {
        if (protection.isEmpty()) {
            return "the centroid of the sensors";
        }
        int zones = protection.areas().size() + (protection.zone().isPresent() ? 1 : 0);
        return zones > 1 ? "the protected zones" : "the protected zone";
    }
}
