package org.dronewatch.placement.plan;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.input.LinkOut;

/**
 * The airspace that is to be covered, and the terms on which a sensor covers it. The settings mean the same as the
 * options of {@code coverage} with the same names.
 *
 * @param area a protected zone of the scene; only cells whose centre is in it count
 * @param weights by the name of a protected zone, the weight of each cell whose centre is in that zone, 0 to 1000. All
 *     other cells have a weight of 1, and a cell that lies in several of these zones has the greatest of their weights.
 *     Only for the objective {@code coverage}
 * @param side side of the square around the candidates if no area is given, above 0 and at most 100 km, m; 500 m by
 *     default. For {@code weakest-route}, the square is around the protected zone and, by default, as large as that of
 *     the command {@code route}
 * @param cell length of a cell's side, above 0 and at most 100 km, m; a fiftieth of the side by default
 * @param heights heights above the ground, in ascending order, each above 0 and at most 10 km, m; 10, 30, 60, 120 and
 *     150 m by default. For {@code weakest-route}, the default heights are those of the command {@code route}, up to
 *     the drone's ceiling
 * @param covered minimum probability of detection at which a sensor covers a cell, 0.008 to 0.996, or 1; 0.5 by default
 * @param within time within which a sensor must detect the drone, s; a single look by default
 * @param heading {@code any}: each of eight headings counts as an eighth of a cell; {@code inbound}: only the heading
 *     towards the protected zone counts. {@code any} by default
 * @param conditions file of conditions, such as night or fog, in the directory of this file or below it, as for
 *     {@code coverage --conditions}: what counts is the coverage, the warning time, or the exposure, under the worst of
 *     these conditions, including the scene as it is
 * @param pointing whether sensors on positioners have turned to the drone ({@code cued}) or search for it
 *     ({@code search}); {@code cued} by default, but {@code search} for {@code weakest-route}
 */
public record AirSettings(
        Optional<String> area,
        Map<String, Double> weights,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) Optional<Double> side,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) Optional<Double> cell,
        @In(value = Quantity.LENGTH, above = 0, to = FieldGrid.HIGHEST) Optional<List<Double>> heights,
        @In(value = Quantity.RATIO, from = FieldCoverage.LEAST_COVERED, to = 1) double covered,
        @In(value = Quantity.DURATION, above = 0, to = 86_400) Optional<Double> within,
        Heading heading,
        Optional<String> conditions,
        Optional<FieldTerms.Turning> pointing) {
    /** The weight of a cell that is in none of the zones with weights. */
    public static final double WEIGHT = 1.0;

    private static final double MOST_WEIGHT = 1000.0;

    /** The headings of the drone that count. */
    public enum Heading {
        /** Eight compass headings, which count equally. */
        ANY,
        /** The heading towards the protected zone. */
        INBOUND
    }

    /** The airspace in a square with sides of 500 m around the candidates. */
    @Defaults
    public static final AirSettings DEFAULT = new AirSettings(
            Optional.empty(),
            Map.of(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            FieldCoverage.DEFAULT_COVERED,
            Optional.empty(),
            Heading.ANY,
            Optional.empty(),
            Optional.empty());

    /** Checks the limits. */
    public AirSettings {
        Limits.check(
                AirSettings.class, area, weights, side, cell, heights, covered, within, heading, conditions, pointing);
        FieldCoverage.checkedProbability(covered);
        heights = heights.map(FieldGrid::checkedHeights);
        weights = Collections.unmodifiableMap(new LinkedHashMap<>(weights));
        weights.forEach((zone, weight) -> {
            if (!(weight >= 0.0 && weight <= MOST_WEIGHT)) {
                throw new IllegalArgumentException("weights." + zone + " " + Quantity.NUMBER.inWords(weight)
                        + ": must be 0" + " to " + Quantity.NUMBER.inWords(MOST_WEIGHT));
            }
        });
    }

    /** The side of the square, m; by default, that of {@code coverage}. */
    public double square() {
        return side.orElse(FieldGrid.DEFAULT_SIDE);
    }

    /** The heights above the ground, m; by default, those of {@code coverage}. */
    public List<Double> levels() {
        return heights.orElse(FieldGrid.HEIGHTS);
    }

    /**
     * The path of the file of conditions; empty without one.
     *
     * @param directory directory of the placement file
     * @throws InputException with a one-line message when it lies elsewhere
     */
    Optional<Path> conditionsFile(Path directory) {
        return conditions.map(name -> {
            Path path = directory.resolve(name).normalize();
            if (!path.startsWith(directory.normalize())) {
                throw new InputException("air.conditions " + PlainText.value(name)
                        + ": must be in the directory of the placement file or below it");
            }
            LinkOut.refuse(directory, path, "air.conditions");
            return path;
        });
    }

    /** The terms on which the drone counts as detected. */
    public FieldTerms terms() {
        return new FieldTerms(pointing.orElse(FieldTerms.Turning.CUED), within);
    }
}
