package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.LayoutWarnings;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.report.coverage.table.WarningTable;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for the placement with the longest warning time found.
 *
 * @param front best layouts for several budgets
 * @param warnings warning times of the layout and of the scene's own sensors; empty if the layout has no sensor, or if
 *     the search was interrupted or its time was up before the warning times were computed
 */
public record WarningPlaceResults(BudgetFront<WarningPlacement> front, Optional<LayoutWarnings> warnings)
        implements PlaceResults {
    @Override
    public WarningPlacement best() {
        return front.best();
    }

    @Override
    public boolean isInterrupted() {
        return front.isInterrupted()
                || warnings.isEmpty() && !best().chosen().isEmpty() && !front.isWithout(LeftOut.WARNINGS);
    }

    @Override
    public PlaceResults without(LeftOut part, SolverLimits limits) {
        return new WarningPlaceResults(front.without(part, limits), warnings);
    }

    @Override
    public PlaceMeasure measure() {
        return PlaceMeasure.of(best().plan());
    }

    @Override
    public List<String> lines() {
        PlaceTable table = new PlaceTable(best(), measure());
        List<String> lines = new ArrayList<>(table.lines());
        lines.add("");
        table.nothing().ifPresent(lines::add);
        table.late().ifPresent(lines::add);
        table.early().ifPresent(lines::add);
        lines.add(new WarningSentences(best(), measure()).worth());
        new SilentDrone(best(), measure()).sentence().ifPresent(lines::add);
        table.uncued().ifPresent(lines::add);
        table.byCondition().ifPresent(lines::add);
        table.present().ifPresent(lines::add);
        table.worstLoss().ifPresent(lines::add);
        lines.addAll(new FrontWords(measure(), best().plan().hasConditions()).lines(front));
        double covered = best().plan().settings().air().covered();
        warnings.ifPresent(its -> {
            lines.add("");
            its.present().ifPresent(own -> {
                lines.add("today:");
                lines.addAll(WarningTable.lines(own, covered));
                lines.add("");
                lines.add("layout:");
            });
            lines.addAll(WarningTable.lines(its.layout(), covered));
            new WarningSentences(best(), measure()).difference().ifPresent(lines::add);
        });
        return lines;
    }

    @Override
    public List<String> reproduction(String layout) {
        return warnings.stream()
                .map(its -> "This command gives these warning times for the layout: dronewatch coverage " + layout + " "
                        + SameCoverage.options(best()))
                .toList();
    }

    @Override
    public ObjectNode toJson() {
        return PlaceFile.of(this, this::addMeasure, PlaceFile.conditions(best()), this::addFlights);
    }

    private void addMeasure(ObjectNode root) {
        root.put("warning", best().measure().name().toLowerCase(Locale.ROOT));
    }

    private void addFlights(ObjectNode root) {
        root.put("flights", best().flights());
        root.put("detected", best().detected());
        root.put("longest_s", Numbers.rounded(best().longest()));
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        return new WarningChapter(this, stage).chapter();
    }
}
