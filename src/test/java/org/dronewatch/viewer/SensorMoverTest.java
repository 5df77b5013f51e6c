package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Moves on a plain with a building 30 m high north of the sensors: which are possible, and why others are not. */
class SensorMoverTest {
    private static final Offset<Double> EXACT = within(1e-6);
    private static final String MORE =
            """
              aside: {kind: camera, position: [20, 0, 4], aim: {azimuth: 90 deg, elevation: 5 deg}, enabled: false}
              turning: {kind: camera, position: [3, 0, 4], fov: 6 deg, positioner: {cues: [round]}}
              ear: {kind: acoustic, position: [0, 5, 4]}
            """;

    @TempDir
    private Path directory;

    private final SensorLayout layout = new SensorLayout();
    private String told = "";
    private final SensorMover mover = new SensorMover(layout, line -> told = line);

    @BeforeEach
    void open() throws Exception {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND + MORE);
        mover.show(site.settings(), site.stage().world());
        mover.select("round");
    }

    private Position place(String id) {
        return layout.settings().sensors().get(id).position();
    }

    @Test
    void itFollowsGroundAndRoofsAtItsHeight() {
        assertThat(mover.above()).isEqualTo(4.0, EXACT);
        mover.begin();
        mover.drag(Optional.of(new Position(50.004, -20, 0)), mover.above());
        assertThat(place("round")).isEqualTo(new Position(50.0, -20, 4));
        assertThat(told).isEqualTo("'round' is at east 50.0 m, north -20.0 m, up 4.0 m, 4.0 m above what is below it");
        // The roof of the building.
        mover.drag(Optional.of(new Position(5, 65, 30)), mover.above());
        assertThat(place("round")).isEqualTo(new Position(5, 65, 34));
        assertThat(mover.above()).isEqualTo(4.0, EXACT);
        assertThat(mover.foot()).contains(new Position(5, 65, 30));
        // By a step over its edge to the ground.
        mover.shift(0, -10);
        assertThat(place("round")).isEqualTo(new Position(5, 55, 4));
        mover.raise(1.5);
        assertThat(place("round")).isEqualTo(new Position(5, 55, 5.5));
    }

    @Test
    void whatIsNotPossibleIsSaidAndChangesNothing() {
        mover.drag(Optional.empty(), 4.0);
        assertThat(told).isEqualTo("'round' stays where it is: there is no ground");
        mover.place(5000, 0, 4);
        assertThat(told).isEqualTo("'round' stays where it is: there is no ground");
        // At the foot of the wall, and within it.
        mover.drag(Optional.of(new Position(0, 62, 10)), 4.0);
        assertThat(told).isEqualTo("'round' stays where it is: that is inside something solid");
        mover.raise(-10.0);
        assertThat(told).isEqualTo("'round' stays where it is: it would be below the surface");
        mover.aim(0.0, 2.0);
        assertThat(told).isEqualTo("'round' stays as it is: its tilt must be between -90 and 90 degrees");
        mover.select("aside");
        mover.shift(1, 0);
        assertThat(told).isEqualTo("'aside' is switched off in the scene: it covers nothing and stays where it is");
        mover.select("ear");
        mover.turn(1.0, 0.0);
        assertThat(told).isEqualTo("'ear' has no direction: there is nothing to turn");
        mover.select("one");
        mover.shift(1, 0);
        assertThat(told).isEqualTo("Select a sensor first: click on its symbol");
        assertThat(layout.moved()).isEmpty();
    }

    @Test
    void itTurnsAndSaysWhatAPositionerDoes() {
        mover.aim(Math.toRadians(350), Math.toRadians(-3));
        mover.turn(Math.toRadians(15), Math.toRadians(5));
        Aim.Direction to = mover.direction().orElseThrow();
        assertThat(Math.toDegrees(to.azimuth())).isEqualTo(5.0, EXACT);
        assertThat(Math.toDegrees(to.elevation())).isEqualTo(2.0, EXACT);
        assertThat(told).isEqualTo("'round' points to 5.0 degrees, tilted by +2.0 degrees");
        mover.select("turning");
        mover.turn(0.5, 0.0);
        assertThat(told).startsWith("'turning' is on a positioner that turns it to the drone");
        assertThat(layout.moved()).containsExactly("round", "turning");
    }

    @Test
    void theLastMovesAreTakenBack() {
        Position home = place("round");
        mover.shift(1, 0);
        mover.begin();
        for (int x = 2; x < 20; x++) {
            mover.drag(Optional.of(new Position(x, 0, 0)), 4.0);
        }
        assertThat(layout.undo()).isTrue();
        assertThat(place("round")).isEqualTo(home.plus(new Position(1, 0, 0)));
        // A move that was refused is none.
        mover.place(5000, 0, 4);
        assertThat(layout.undo()).isTrue();
        assertThat(place("round")).isEqualTo(home);
        assertThat(layout.isUndoable()).isFalse();
        assertThat(layout.undo()).isFalse();
        mover.shift(0, 3);
        layout.reset();
        assertThat(layout.moved()).isEmpty();
        assertThat(layout.undo()).isTrue();
        assertThat(place("round")).isEqualTo(home.plus(new Position(0, 3, 0)));
    }
}
