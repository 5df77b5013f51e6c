package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldTerms;
import org.dronewatch.placement.site.AirSettings;
import org.dronewatch.placement.site.SitePlacement;

/** The options with which {@code coverage} assesses the scene of a layout in the same cells and on the same terms. */
final class SameCoverage {
    private SameCoverage() {}

    /** The options in one line. */
    static String options(SitePlacement placement) {
        AirSettings air = placement.plan().settings().air();
        FieldGrid grid = placement.grid();
        List<String> words = new ArrayList<>();
        if (air.area().isPresent()) {
            words.add("--area " + air.area().get());
        } else {
            words.add("--centre=" + exact(grid.east()) + "," + exact(grid.north()));
            words.add("--side " + exact(grid.side()));
        }
        words.add("--cell " + exact(grid.cell()));
        words.add(
                "--heights " + grid.heights().stream().map(SameCoverage::exact).collect(Collectors.joining(",")));
        if (air.heading() == AirSettings.Heading.INBOUND) {
            words.add("--heading inbound");
        }
        if (Double.compare(air.covered(), FieldCoverage.DEFAULT_COVERED) != 0) {
            words.add("--covered " + exact(air.covered()));
        }
        air.within().ifPresent(time -> words.add("--within " + exact(time)));
        if (air.pointing().filter(FieldTerms.Turning.SEARCH::equals).isPresent()) {
            words.add("--pointing " + FieldTerms.Turning.SEARCH.name().toLowerCase(Locale.ROOT));
        }
        if (!placement
                .plan()
                .drone()
                .equals(placement.plan().present().individualDrones().keySet().stream()
                        .findFirst()
                        .orElse(""))) {
            words.add("--drone " + placement.plan().drone());
        }
        return String.join(" ", words);
    }

    /** All digits that are needed for the same number. */
    private static String exact(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? String.format(Locale.ROOT, "%d", (long) value)
                : Double.toString(value);
    }
}
