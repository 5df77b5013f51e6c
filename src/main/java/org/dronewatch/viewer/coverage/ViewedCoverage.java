package org.dronewatch.viewer.coverage;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldDraft;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.scenario.SceneSettings;

/** A displayed coverage, and what remains of it when some of its sensors are switched off. Thread-safe. */
public final class ViewedCoverage {
    /** The number of sets of sensors for which the coverage is kept. */
    private static final int MOST_KEPT = 12;

    private final FieldRequest request;
    private final FieldCoverage all;
    private final Map<Set<String>, FieldCoverage> kept = new LinkedHashMap<>(MOST_KEPT, 0.75f, true);

    /**
     * Evaluates a field.
     *
     * @param field what was requested, perhaps only its lowest heights
     */
    ViewedCoverage(FieldRequest request, DetectionField field) {
        this.request = request;
        this.all = new FieldCoverage(field, request.choice(), request.covered());
    }

    public FieldRequest request() {
        return request;
    }

    /** The coverage with all sensors. */
    FieldCoverage all() {
        return all;
    }

    /** The cells and the heights that have been computed. */
    public FieldGrid grid() {
        return all.field().grid();
    }

    /** Whether all heights that were requested have been computed. */
    boolean isWhole() {
        return grid().heights().size() == request.grid().heights().size();
    }

    /** Whether sensors are moved or turned in other settings of the same scene. */
    boolean isMoved(SceneSettings other) {
        return other != request.settings()
                && !FieldDraft.movedSensors(all.field(), other).isEmpty();
    }

    /** A sentence about the heights that are missing, with a space before it; empty if none is. */
    String missing() {
        return isWhole()
                ? ""
                : String.format(
                        Locale.ROOT,
                        " Cancelled: complete for %d of %d heights.",
                        grid().heights().size(),
                        request.grid().heights().size());
    }

    /** The coverage without some sensors, given by their names. */
    synchronized FieldCoverage without(Set<String> off) {
        FieldCoverage rest = kept.get(off);
        if (rest == null) {
            rest = all.without(off);
            kept.put(Set.copyOf(off), rest);
            if (kept.size() > MOST_KEPT) {
                kept.remove(kept.keySet().iterator().next());
            }
        }
        return rest;
    }
}
