package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for the placement with the most coverage found.
 *
 * @param front best layouts for several budgets
 * @param fields coverage of the layout and of the scene's own sensors; empty if the layout has no sensor, or if the
 *     search was interrupted or its time was up before the coverage was computed
 */
public record CoveragePlaceResults(BudgetFront<SitePlacement> front, Optional<LayoutFields> fields)
        implements PlaceResults {
    @Override
    public SitePlacement best() {
        return front.best();
    }

    @Override
    public boolean isInterrupted() {
        return front.isInterrupted()
                || fields.isEmpty() && !best().chosen().isEmpty() && !front.isWithout(LeftOut.COVERAGE);
    }

    @Override
    public PlaceResults without(LeftOut part, SolverLimits limits) {
        return new CoveragePlaceResults(front.without(part, limits), fields);
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
        lines.addAll(new CoverageSentences(this).lines());
        lines.addAll(new FrontWords(measure(), best().plan().hasConditions()).lines(front));
        lines.addAll(new ZoneTable(best()).lines());
        fields.ifPresent(its -> {
            lines.add("");
            lines.addAll(FieldsTable.lines(its, best()));
        });
        return lines;
    }

    @Override
    public List<String> reproduction(String layout) {
        return fields.stream()
                .map(its -> "This command gives the figures of the layout: dronewatch coverage " + layout + " "
                        + SameCoverage.options(best()))
                .toList();
    }

    @Override
    public ObjectNode toJson() {
        return PlaceFile.of(this, terms -> {}, PlaceFile.conditions(best()), this::addFields);
    }

    private void addFields(ObjectNode root) {
        new ZoneTable(best()).add(root);
        FieldsFile.add(root, fields, best().plan().settings().conditions().fold());
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        return new CoverageChapter(this, stage).chapter();
    }
}
