package org.dronewatch.route.proof;

import java.util.List;
import org.dronewatch.analysis.field.FieldSample;
import org.dronewatch.route.FieldExposure;
import org.dronewatch.route.ModeField;
import org.dronewatch.scenario.SceneSettings;

/**
 * Whether the cells of a search are small enough for its site. {@linkplain FieldSample Places} between the centres of
 * the cells are tried. A place counts as unseen if there is a mode of flight in which no sensor detects the drone
 * there, although in this mode sensors detect the drone in every cell around the place, so that even the lower bound on
 * the exposure assumes a detection there. A passage that is narrower than a cell may lead to such a place.
 *
 * @param tried number of places at which the drone can be
 * @param unseen number of these places at which, in some mode, no sensor detects the drone, but the lower bound assumes
 *     a detection
 */
public record UnseenPlaces(int tried, int unseen) {
    /**
     * Tries the places between the cells of a field.
     *
     * @param modes the modes of flight, at least one, with their fields of single looks over the same grid
     * @param settings settings of the scene
     * @throws IllegalArgumentException if there is no mode, or the grids differ
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static UnseenPlaces of(List<ModeField> modes, SceneSettings settings) {
        FieldSample all = modes.stream()
                .map(mode -> sample(mode, settings))
                .reduce(FieldSample::either)
                .orElseThrow(() -> new IllegalArgumentException("0 modes: there must be at least one"));
        return new UnseenPlaces(all.openCount(), all.undetectedCount());
    }

    private static FieldSample sample(ModeField flown, SceneSettings settings) {
        FieldExposure exposure = FieldExposure.of(flown, settings);
        return FieldSample.of(flown.field(), place -> exposure.least(place, place, 0) > 0.0);
    }
}
