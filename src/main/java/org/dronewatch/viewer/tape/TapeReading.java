package org.dronewatch.viewer.tape;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.analysis.survey.LineOfSight;
import org.dronewatch.analysis.survey.LineOfSight.Blocked;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.report.html.BlockerWords;
import org.dronewatch.viewer.part.Texts;

/**
 * What the viewer's measuring tape shows: distances along a straight line between two points, and what blocks the line
 * of sight.
 *
 * @param tape the measured line
 * @param blocked what blocks the line of sight; empty if it is clear
 */
public record TapeReading(Tape tape, Optional<Blocked> blocked) {
    private static final double IN_A_DEGREE = 10.0;
    private static final double WHOLE_TURN = 360.0;

    /** Reads a tape. */
    public static TapeReading of(Tape tape, LineOfSight sight) {
        return new TapeReading(tape, sight.between(tape.from().eye(), tape.to().eye()));
    }

    /** The reading in one line. */
    public String words() {
        return ends(tape) + lengths(tape) + "; " + sight();
    }

    /** The reading of a tape whose line of sight has not been traced. */
    public static String wordsOf(Tape tape) {
        return ends(tape) + lengths(tape);
    }

    private static String ends(Tape tape) {
        return "From " + tape.from().name() + " to " + tape.to().name() + ": ";
    }

    private static String lengths(Tape tape) {
        String bearing = Double.isNaN(tape.bearingDeg())
                ? ""
                : String.format(Locale.ROOT, ", bearing %.1f deg", rounded(tape.bearingDeg()));
        return String.format(
                Locale.ROOT,
                "%.1f m (horizontal %.1f m, height %+.1f m%s, elevation %+.1f deg)",
                tape.distance(),
                tape.horizontal(),
                tape.height(),
                bearing,
                tape.elevationDeg());
    }

    /** A bearing of 359.96 degrees is shown as 0.0. */
    private static double rounded(double bearing) {
        return Math.rint(IN_A_DEGREE * bearing) / IN_A_DEGREE % WHOLE_TURN;
    }

    private String sight() {
        return blocked.map(found -> String.format(
                        Locale.ROOT,
                        "line of sight blocked after %.1f m by %s at %s",
                        found.at().minus(tape.from().place()).length(),
                        name(found),
                        Texts.place(found.at())))
                .orElse("line of sight clear");
    }

    /** What blocks the line: a name if it has one, otherwise its role. */
    private static String name(Blocked found) {
        String name = BlockerWords.name(found.blocker());
        ModelRole role = found.blocker().obstacle().model().role();
        return name.isEmpty() ? "a model (" + role.name().toLowerCase(Locale.ROOT) + ")" : name;
    }
}
