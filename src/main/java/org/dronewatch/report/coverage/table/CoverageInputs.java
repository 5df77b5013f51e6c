package org.dronewatch.report.coverage.table;

import java.util.Optional;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.geo.Origin;
import org.dronewatch.report.file.Numbers;

/**
 * The inputs of a coverage assessment, as stated in its result files.
 *
 * @param scene name of the scene
 * @param drone name of the drone
 * @param heading which heading of the drone counts: {@code worst}, {@code best} or {@code inbound}
 * @param covered the probability with which a sensor must detect the drone to cover a cell
 * @param terms the terms on which the drone counts as detected
 * @param area name of the protected area outside which cells do not count; empty if all cells count
 * @param origin geographic position of the scene's origin, if it is known
 */
public record CoverageInputs(
        String scene,
        String drone,
        String heading,
        double covered,
        FieldTerms terms,
        Optional<String> area,
        Optional<Origin> origin) {

    /** The time in which a sensor has to detect the drone, s; empty for one look. */
    public Optional<Double> within() {
        return terms.within();
    }

    /**
     * The area outside which cells do not count, as the end of a phrase: {@code  in 'yard'}; empty if there is none.
     */
    public String areaInWords() {
        return area.map(name -> " in '" + name + "'").orElse("");
    }

    /** What counts as covered, as the end of a phrase; empty if that is what counts as detected. */
    String termsInWords() {
        return within().map(time -> ", covered within " + Numbers.text(time) + " s"
                        + withProbability()
                        + ", and causes of misses in single looks")
                .orElseGet(() -> hasDefaultProbability()
                        ? ""
                        : ", covered" + withProbability() + ", detected with " + detectedInWords());
    }

    /** What counts as detected, in a sentence, where that differs from what counts as covered. */
    Optional<String> detectedInASentence() {
        return within().isEmpty() && hasDefaultProbability()
                ? Optional.empty()
                : Optional.of("Here, \"detected\" means a probability of " + detectedInWords() + " in a single look.");
    }

    private static String detectedInWords() {
        return Numbers.text(FieldCoverage.DEFAULT_COVERED) + " or more";
    }

    /**
     * The heading in words, {@code on the worst heading} or {@code inbound}, followed by {@code , sensors searching} if
     * sensors on positioners search.
     */
    public String headingInWords() {
        return (heading.equals("inbound") ? heading : "on the " + heading + " heading")
                + (terms.pointing() == FieldTerms.Turning.SEARCH ? ", sensors searching" : "");
    }

    /** The time in which a sensor has to detect the drone: {@code 10 s}; empty for one look. */
    public String timeInWords() {
        return within().map(time -> Numbers.text(time) + " s").orElse("");
    }

    /** The probability with which a sensor must detect the drone, as the end of a phrase; empty for the default. */
    public String withProbability() {
        return withProbability(covered);
    }

    /**
     * A probability with which a sensor must detect the drone, 0.008 to 0.996, or 1, as the end of a phrase; empty for
     * the default.
     */
    public static String withProbability(double covered) {
        return isDefault(covered) ? "" : " with a probability of " + Numbers.text(covered) + " or more";
    }

    private static boolean isDefault(double covered) {
        return Double.compare(covered, FieldCoverage.DEFAULT_COVERED) == 0;
    }

    /** Whether {@link #covered} is the default. */
    public boolean hasDefaultProbability() {
        return isDefault(covered);
    }
}
