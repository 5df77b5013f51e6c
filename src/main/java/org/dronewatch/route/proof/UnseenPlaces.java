package org.dronewatch.route.proof;

import org.dronewatch.analysis.field.FieldSample;
import org.dronewatch.route.FieldExposure;
import org.dronewatch.route.ModeField;
import org.dronewatch.scenario.SceneSettings;

/**
 * Whether the cells of a search are small enough for its site: at how many of the {@linkplain FieldSample places} tried
 * between the middles of the cells no sensor detects the drone, although the drone is detected in every cell around
 * them, so that even the lower bound of the exposure counts on it. A passage that is narrower than a cell may lead
 * there.
 *
 * @param tried number of places at which the drone can be
 * @param unseen number of those at which no sensor detects it, but the lower bound counts on a detection
 */
public record UnseenPlaces(int tried, int unseen) {
    /**
     * Tries the places between the cells of a field.
     *
     * @param flown the mode of flight with its field of single looks
     * @param settings settings of the scene
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static UnseenPlaces of(ModeField flown, SceneSettings settings) {
        FieldExposure exposure = FieldExposure.of(flown, settings);
        FieldSample sample = FieldSample.of(flown.field(), place -> exposure.least(place, place, 0) > 0.0);
        return new UnseenPlaces(sample.openCount(), sample.undetectedCount());
    }
}
