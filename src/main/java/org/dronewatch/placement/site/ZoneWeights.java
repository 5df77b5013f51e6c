package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;

/** How much each cell of the airspace counts: those in some protected zones more, or less, than all others. */
final class ZoneWeights {
    private final FieldGrid grid;
    private final List<AreaZone> zones = new ArrayList<>();
    private final List<Double> weights = new ArrayList<>();

    /**
     * The weights of a plan.
     *
     * @throws InputException when one of the zones is not in the scene
     */
    ZoneWeights(PlacePlan plan, FieldGrid grid) {
        this.grid = grid;
        AlertSettings alert = plan.present().alert();
        Map<String, Double> given = plan.settings().air().weights();
        given.forEach((name, weight) -> {
            zones.add(zone(name, "air.weights", alert));
            weights.add(weight);
        });
    }

    /**
     * A protected zone in plan view.
     *
     * @param setting setting that names the zone
     * @throws InputException when it is not in the scene
     */
    static AreaZone zone(String name, String setting, AlertSettings alert) {
        return AreaZone.inPlan(name, alert).orElseThrow(() -> {
            List<String> known = AreaZone.namesInPlan(alert);
            return new InputException(setting + " " + PlainText.value(name) + ": no such zone; the scene protects "
                    + (known.isEmpty() ? "nothing" : String.join(", ", known)) + Spelling.didYouMean(name, known));
        });
    }

    /** The number of zones that have a weight. */
    int count() {
        return zones.size();
    }

    String name(int zone) {
        return zones.get(zone).name();
    }

    double weight(int zone) {
        return weights.get(zone);
    }

    boolean isIn(int zone, int column, int row) {
        return zones.get(zone).covers(grid.x(column), grid.y(row));
    }

    /** The weight of a cell: the greatest of the zones that its centre is in, or 1 if it is in none. */
    double of(int column, int row) {
        double greatest = Double.NaN;
        for (int zone = 0; zone < zones.size(); zone++) {
            if (isIn(zone, column, row)) {
                greatest = Double.isNaN(greatest) ? weight(zone) : Math.max(greatest, weight(zone));
            }
        }
        return Double.isNaN(greatest) ? AirSettings.WEIGHT : greatest;
    }
}
