package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.assertj.core.data.Offset;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.canvas.SensorMark;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.UnsavedMoves;
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
        assertThat(told)
                .isEqualTo("'round' is at east 50.0 m, north -20.0 m, up 4.0 m, 4.0 m above the surface below" + " it");
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
        assertThat(told).isEqualTo("'round' stays where it is: it would be inside something solid");
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
        assertThat(told).isEqualTo("'round' has an azimuth of 5.0 degrees and a tilt of +2.0 degrees");
        mover.select("turning");
        mover.turn(0.5, 0.0);
        assertThat(told).startsWith("'turning' is on a positioner, which turns it towards the drone");
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

    @Test
    void whatWasUndoneIsDoneAgainUntilAnotherMove() {
        Position home = place("round");
        mover.shift(1, 0);
        mover.shift(0, 2);
        layout.undo();
        layout.undo();
        assertThat(place("round")).isEqualTo(home);
        assertThat(layout.redo()).isTrue();
        assertThat(place("round")).isEqualTo(home.plus(new Position(1, 0, 0)));
        // A move that is refused is none.
        mover.place(5000, 0, 4);
        assertThat(layout.isRedoable()).isTrue();
        assertThat(layout.redo()).isTrue();
        assertThat(place("round")).isEqualTo(home.plus(new Position(1, 2, 0)));
        assertThat(layout.redo()).isFalse();
        layout.undo();
        mover.shift(-3, 0);
        assertThat(layout.isRedoable()).isFalse();
        assertThat(layout.redo()).isFalse();
        assertThat(layout.undo()).isTrue();
        assertThat(place("round")).isEqualTo(home.plus(new Position(1, 0, 0)));
    }

    /** They are asked about once there are any, and no longer once they are saved or undone. */
    @Test
    void movesThatAreInNoFileAreNotLostWithoutAQuestion() {
        List<Set<String>> asked = new ArrayList<>();
        UnsavedMoves.Answer[] answer = {UnsavedMoves.Answer.STAY};
        boolean[] isWritten = {false};
        UnsavedMoves moves = new UnsavedMoves(
                layout,
                () -> {
                    if (isWritten[0]) {
                        layout.markSaved();
                    }
                },
                moved -> {
                    asked.add(moved);
                    return answer[0];
                });
        assertThat(moves.mayLeave()).isTrue();
        mover.shift(1, 0);
        assertThat(moves.mayLeave()).isFalse();
        answer[0] = UnsavedMoves.Answer.DISCARD;
        assertThat(moves.mayLeave()).isTrue();
        // The user cancels the choice of a file.
        answer[0] = UnsavedMoves.Answer.SAVE;
        assertThat(moves.mayLeave()).isFalse();
        isWritten[0] = true;
        assertThat(moves.mayLeave()).isTrue();
        assertThat(asked).hasSize(4).allMatch(Set.of("round")::equals);
        assertThat(moves.mayLeave()).isTrue();
        layout.undo();
        // The file has another layout than the scene, which is shown again.
        assertThat(layout.unsaved()).isEmpty();
        layout.redo();
        assertThat(layout.unsaved()).isEmpty();
        assertThat(asked).hasSize(4);
        // Of two sensors that were moved, one has been saved.
        mover.select("ear");
        mover.shift(0, 1);
        assertThat(layout.unsaved()).containsExactly("ear");
        layout.markSaved();
        assertThat(layout.unsaved()).isEmpty();
        // Of two that have been saved, one is moved back: no file has this layout.
        layout.undo();
        assertThat(layout.unsaved()).containsExactly("ear");
        assertThat(UnsavedMoves.words(Set.of("round")))
                .isEqualTo("'round' was changed, and the scene has not been saved since.");
    }

    /** Two sensors on one mast: each can be selected and moved, and the other stays. */
    @Test
    void clicksInOnePlaceSelectOneSensorAfterTheOther() {
        mover.select("ear");
        mover.place(place("round").x(), place("round").y(), place("round").z());
        assertThat(place("ear")).isEqualTo(place("round"));
        List<String> chosen = new ArrayList<>();
        Optional<String> selected = Optional.empty();
        for (int click = 0; click < 3; click++) {
            SymbolPick pick = SymbolPick.of(
                    state(selected),
                    at -> Math.hypot(
                            at.x() - place("round").x(), at.y() - place("round").y()),
                    2.0);
            selected = pick.chosen();
            chosen.add(selected.orElseThrow());
            assertThat(pick.hint()).hasValueSatisfying(hint -> assertThat(hint).contains(" of 2 here"));
        }
        assertThat(chosen).containsExactly("round", "ear", "round");
        mover.select("round");
        Position mast = place("round");
        mover.begin();
        mover.drag(Optional.of(new Position(40, -20, 0)), mover.above());
        assertThat(place("ear")).isEqualTo(mast);
        assertThat(place("round")).isEqualTo(new Position(40, -20, mast.z()));
        assertThat(SymbolPick.of(state(Optional.of("round")), at -> 9.0, 2.0).chosen())
                .isEmpty();
    }

    private SiteState state(Optional<String> selected) {
        List<SensorMark> marks = layout.settings().enabledSensors().entrySet().stream()
                .map(sensor -> new SensorMark(
                        sensor.getKey(),
                        sensor.getValue().kind(),
                        sensor.getValue().position(),
                        Outlined.outline(sensor.getValue()),
                        false))
                .toList();
        return new SiteState("site", 0.0, marks, List.of(), selected, Optional.empty(), List.of());
    }
}
