package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.report.route.RouteInputs;

/** The options with which {@code route} searches the scene of a layout in the same cells and on the same terms. */
final class SameRoute {
    private SameRoute() {}

    /** The options in one line. */
    static String options(RoutePlacement placement, RouteInputs inputs) {
        FieldGrid grid = inputs.grid();
        List<String> words = new ArrayList<>();
        words.add("--side " + SameCoverage.exact(grid.side()));
        words.add("--cell " + SameCoverage.exact(grid.cell()));
        words.add(
                "--heights " + grid.heights().stream().map(SameCoverage::exact).collect(Collectors.joining(",")));
        if (inputs.pointing() == FieldTerms.Turning.CUED) {
            words.add("--pointing " + FieldTerms.Turning.CUED.name().toLowerCase(Locale.ROOT));
        }
        SameCoverage.drone(placement.plan()).ifPresent(words::add);
        return String.join(" ", words);
    }
}
