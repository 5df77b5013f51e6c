package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.report.file.ShellWord;

/** The options with which {@code coverage} assesses the scene of a layout in the same cells and on the same terms. */
final class SameCoverage {
    /** A coordinate of smaller magnitude counts as 0, m. */
    private static final double NOTHING = 1e-9;

    private SameCoverage() {}

    /** The options in one line. */
    static String options(PlacedLayout placement) {
        AirSettings air = placement.plan().settings().air();
        FieldGrid grid = placement.grid();
        List<String> words = new ArrayList<>();
        if (air.area().isPresent()) {
            words.add("--area " + ShellWord.of(air.area().get()));
        } else {
            words.add("--centre=" + metres(grid.east()) + "," + metres(grid.north()));
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
        drone(placement.plan()).ifPresent(words::add);
        return String.join(" ", words);
    }

    /** The option for the drone; empty if it is the first of the scene, which needs none. */
    static Optional<String> drone(PlacePlan plan) {
        boolean isFirst = plan.present().individualDrones().keySet().stream()
                .findFirst()
                .filter(plan.drone()::equals)
                .isPresent();
        return isFirst ? Optional.empty() : Optional.of("--drone " + ShellWord.of(plan.drone()));
    }

    /** A coordinate, without what rounding has left of 0. */
    private static String metres(double coordinate) {
        return exact(Math.abs(coordinate) < NOTHING ? 0.0 : coordinate);
    }

    /** A number with all digits that are needed to read it back exactly. */
    static String exact(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? String.format(Locale.ROOT, "%d", (long) value)
                : Double.toString(value);
    }
}
