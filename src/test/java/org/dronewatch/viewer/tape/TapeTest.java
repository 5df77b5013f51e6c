package org.dronewatch.viewer.tape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.dronewatch.analysis.survey.LineOfSight;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Yard;
import org.dronewatch.run.Stage;
import org.dronewatch.viewer.tape.Tape.End;
import org.dronewatch.world.Visibility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A tape in the yard, whose wall is 20 m x 1 m x 8 m: distances of right triangles, and what blocks the line. */
class TapeTest {
    private static final Position SOUTH = new Position(0, -15, 2);

    @TempDir
    private Path directory;

    private static Tape tape(Position from, Position to) {
        return new Tape(End.of("camera", from), End.of("drone", to));
    }

    @Test
    void distancesAndAnglesAreThoseOfARightTriangle() {
        Tape tape = tape(new Position(10, 20, 5), new Position(10 - 30, 20 + 40, 5 - 50));

        assertThat(tape.horizontal()).isEqualTo(50.0);
        assertThat(tape.height()).isEqualTo(-50.0);
        assertThat(tape.distance()).isCloseTo(50.0 * Math.sqrt(2.0), within(1e-12));
        assertThat(tape.elevationDeg()).isCloseTo(-45.0, within(1e-12));
        assertThat(tape.bearingDeg()).isCloseTo(360.0 - Math.toDegrees(Math.atan(0.75)), within(1e-12));
        assertThat(tape(SOUTH, new Position(5, -15, 2)).bearingDeg()).isEqualTo(90.0);
        assertThat(tape(SOUTH, new Position(0, -20, 2)).bearingDeg()).isEqualTo(180.0);
    }

    @Test
    void aVerticalTapeHasNoBearingAndNearlyNorthIsZero() {
        Tape up = tape(SOUTH, new Position(0, -15, 7));
        assertThat(up.bearingDeg()).isNaN();
        assertThat(TapeReading.wordsOf(up))
                .isEqualTo("From 'camera' to 'drone': 5.0 m (horizontal 0.0 m, height +5.0 m, elevation +90.0 deg)");
        Tape nearly = tape(SOUTH, new Position(-0.0001, 85, 2));
        assertThat(TapeReading.wordsOf(nearly)).contains("bearing 0.0 deg");
    }

    /** The wall's south face is the plane y = 0, 15 m north of the camera. */
    @Test
    void theWallBlocksTheLineWhereItStandsAndNotAboveIt() {
        Stage stage = new Yard(directory).stage();
        LineOfSight sight = new LineOfSight(stage);
        TapeReading behind = TapeReading.of(tape(SOUTH, new Position(0, 15, 2)), sight);

        Position at = behind.blocked().orElseThrow().at();
        assertThat(at.minus(new Position(0, 0, 2)).length()).isLessThan(1e-6);
        assertThat(behind.words())
                .isEqualTo("From 'camera' to 'drone': 30.0 m (horizontal 30.0 m, height +0.0 m, bearing 0.0 deg,"
                        + " elevation +0.0 deg); line of sight blocked after 15.0 m by yard.obj at"
                        + " east 0.0 m, north 0.0 m, up 2.0 m");
        TapeReading above = TapeReading.of(tape(SOUTH, new Position(0, 15, 30)), sight);
        assertThat(above.blocked()).isEmpty();
        assertThat(above.words()).endsWith("; line of sight clear");
    }

    /** Both directions, and the same answer as the sensors' own query. */
    @Test
    void theLineOfSightIsThatOfTheSensors() {
        Stage stage = new Yard(directory).stage();
        LineOfSight sight = new LineOfSight(stage);
        Visibility visibility = new Visibility(stage.world());
        int blocked = 0;
        for (int x = -25; x <= 25; x += 5) {
            for (int z = 1; z <= 25; z += 4) {
                Position to = new Position(x, 12, z);
                boolean isFree = visibility.isFree(SOUTH, to);
                assertThat(sight.between(SOUTH, to).isEmpty()).as("%s", to).isEqualTo(isFree);
                assertThat(sight.between(to, SOUTH).isEmpty()).as("%s", to).isEqualTo(isFree);
                blocked += isFree ? 0 : 1;
            }
        }
        assertThat(blocked).isBetween(10, 60);
    }

    /** A point that is clicked on lies on a surface, or a rounding error behind it: seen from in front, it is free. */
    @Test
    void aPointOnASurfaceIsSeenFromItsSideOnly() {
        LineOfSight sight = new LineOfSight(new Yard(directory).stage());
        End camera = End.of("camera", SOUTH);
        End face = End.onSurface(new Position(3, 1e-4, 4), new Position(0, -100, 40));

        assertThat(TapeReading.of(new Tape(camera, face), sight).blocked()).isEmpty();
        assertThat(face.eye().minus(face.place()).length()).isLessThan(0.012);
        End ground = End.onSurface(new Position(0, -25, -1e-4), new Position(0, -100, 40));
        assertThat(TapeReading.of(new Tape(ground, camera), sight).blocked()).isEmpty();
        End far = End.of("drone", new Position(3, 15, 4));
        assertThat(TapeReading.of(new Tape(face, far), sight).blocked()).isPresent();
    }
}
