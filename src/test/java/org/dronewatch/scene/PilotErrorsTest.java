package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Stream;
import nl.tudelft.simulation.dsol.SimRuntimeException;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What a pilot does wrong is one line that names drone, time and limit. */
class PilotErrorsTest {
    private static final Position EAST = new Position(1, 0, 0);

    /** What a pilot does at one second, and what it is answered. */
    static Stream<Arguments> mistakes() {
        return Stream.of(
                mistake(
                        run -> run.drone("prey").fly(EAST),
                        "drone 'prey' at 1.0 s: cannot be steered: its flight is not of the kind 'steered'"),
                mistake(
                        run -> run.drone("hunter").fly(new Position(30, 0, 0)),
                        "drone 'hunter' at 1.0 s: speed 30.0 m/s must be at most the drone's 25.0 m/s"),
                mistake(run -> run.drone("hunter").fly(null), "drone 'hunter' at 1.0 s: velocity is missing"),
                mistake(
                        run -> run.drone("hunter").fly(EAST, (Attitude) null),
                        "drone 'hunter' at 1.0 s: attitude is missing"),
                mistake(run -> run.drone("hunter").flyTo(null, 3.0), "drone 'hunter' at 1.0 s: target is missing"),
                mistake(
                        run -> run.drone("hunter").flyTo(EAST, 1.0),
                        "drone 'hunter' at 1.0 s: arrival at 1.0 s must be after the command, at 1.0 s"),
                mistake(
                        run -> run.drone("hunter").state(1.5),
                        "drone 'hunter' at 1.0 s: where a steered drone will be at 1.5 s is not known at 1.0 s"),
                mistake(
                        run -> run.drone("hunter").state(-3.0),
                        "drone 'hunter' at 1.0 s: its state at -3.0 s: the time must be 0 s or later"),
                mistake(
                        run -> run.drone("prey").state(Double.NaN),
                        "drone 'prey' at 1.0 s: its state at NaN s: the time must be 0 s or later"),
                mistake(
                        run -> run.drone("nobody").state(),
                        "pilot at 1.0 s: no drone 'nobody'; the scene has prey, hunter"),
                mistake(
                        run -> run.after(-1.0, () -> {}),
                        "pilot at 1.0 s: after -1.0 s: the delay must be 0 s or more"));
    }

    private static Arguments mistake(Consumer<PilotedRun> action, String message) {
        return Arguments.of(action, message);
    }

    @ParameterizedTest(name = "{1}")
    @MethodSource("mistakes")
    void eachIsOneLine(Consumer<PilotedRun> action, String message) {
        SceneRunner runner = piloted(run -> run.after(1.0, () -> action.accept(run)));
        assertThatThrownBy(runner::run).isInstanceOf(InputException.class).hasMessage(message);
    }

    /** An event that a pilot schedules without {@code after} is answered alike. */
    @Test
    void soItIsInAnEventOfTheSimulator() {
        SceneRunner runner = piloted(run -> {
            try {
                run.simulator().scheduleEventAbs(1.0, () -> run.drone("prey").fly(EAST));
            } catch (SimRuntimeException e) {
                throw new IllegalStateException(e);
            }
        });
        assertThatThrownBy(runner::run)
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("drone 'prey' at 1.0 s: cannot be steered");
    }

    /** So it is with a pilot that cannot even be made, or is null. */
    @Test
    void aPilotThatCannotBeMadeIsOneLine() {
        SceneRunner runner = piloted(run -> {});
        assertThatThrownBy(runner.pilot(() -> unfinished())::run)
                .isInstanceOf(InputException.class)
                .hasMessageMatching(
                        "no pilot from org\\.dronewatch\\.scene\\.PilotErrorsTest: "
                                + "java\\.lang\\.UnsupportedOperationException: no plan yet, "
                                + "at org\\.dronewatch\\.scene\\.PilotErrorsTest\\.unfinished\\(PilotErrorsTest\\.java:\\d+\\)");
        assertThatThrownBy(runner.pilot(() -> null)::run)
                .isInstanceOf(InputException.class)
                .hasMessage("the scene's pilot is missing: a pilot may be Pilot.NONE, but not null");
    }

    private static Pilot unfinished() {
        throw new UnsupportedOperationException("no plan yet");
    }

    /**
     * Whatever a pilot throws is the user's mistake, too: one line with pilot, time, exception and the line of the
     * code.
     */
    @Test
    void anExceptionOfItsOwnNamesPilotTimeAndLine() {
        assertFault(run -> forgotten.length(), 0.0, "java.lang.NullPointerException: ", "forgotten");
        assertFault(
                run -> run.after(0.75, () -> Objects.requireNonNull(forgotten, "no plan")),
                0.75,
                "java.lang.NullPointerException: no plan, at ",
                "");
        assertFault(
                run -> run.after(0.5, () -> fail("lost\nits way")),
                0.5,
                "java.lang.IllegalStateException: lost its way, at ",
                ".fail(PilotErrorsTest.java:");
        assertFault(
                run -> run.after(0.5, () -> new Attitude(Double.NaN, 0, 0)),
                0.5,
                "java.lang.IllegalArgumentException: ",
                ", at org.dronewatch.scene.PilotErrorsTest.lambda$");
        assertFault(
                run -> {
                    try {
                        run.simulator().scheduleEventAbs(0.25, () -> fail("in an event"));
                    } catch (SimRuntimeException e) {
                        throw new AssertionError(e);
                    }
                },
                0.25,
                "java.lang.IllegalStateException: in an event, at ",
                ".fail(PilotErrorsTest.java:");
    }

    private final String forgotten = null;

    private static void fail(String message) {
        throw new IllegalStateException(message);
    }

    private static void assertFault(Pilot pilot, double time, String exception, String place) {
        assertThatThrownBy(() -> piloted(pilot).run())
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("pilot org.dronewatch.scene.PilotErrorsTest at " + time + " s: " + exception)
                .hasMessageContaining(place)
                .hasMessageMatching(
                        ".*, at org\\.dronewatch\\.scene\\.PilotErrorsTest\\.\\S+\\(PilotErrorsTest\\.java:\\d+\\)")
                .hasCauseInstanceOf(RuntimeException.class);
    }

    /** A mistake in a look of the same run is not the pilot's. */
    @Test
    void whatFailsInALookIsNotThePilots() {
        IllegalStateException other = new IllegalStateException("a listener's");
        SceneRunner runner = piloted(run -> {}).onFrame(frame -> {
            throw other;
        });
        assertThatThrownBy(runner::run).isSameAs(other);
    }

    private static SceneRunner piloted(Pilot pilot) {
        return deaf(new Pursuit())
                .set("sensors.camera.enabled", "false")
                .until(1.0)
                .pilot(() -> pilot);
    }

    /** Mistakes are the same whatever microphones hear meanwhile, which takes longest. */
    private static SceneRunner deaf(Scene scene) {
        return new SceneRunner(scene).set("sensors.ear.enabled", "false").set("sensors.far-ear.enabled", "false");
    }

    /** Before any look, between looks, and after the run. */
    @Test
    void onlyTheThreadThatRunsTheSceneSteers() {
        List<Throwable> refused = new ArrayList<>();
        List<PilotedRun> runs = new ArrayList<>();
        piloted(run -> {
                    runs.add(run);
                    refused.add(elsewhere(() -> run.drone("hunter").fly(EAST)));
                    run.after(
                            0.0,
                            () -> refused.add(
                                    elsewhere(() -> run.drone("hunter").fly(EAST))));
                    run.after(
                            0.75,
                            () -> refused.add(
                                    elsewhere(() -> run.drone("hunter").flyTo(EAST, 3.0))));
                    run.after(0.75, () -> run.drone("hunter").fly(new Position(0, 0, 1)));
                    run.after(0.8, () -> assertThat(
                                    elsewhere(() -> run.drone("hunter").state()))
                            .as("any thread may ask")
                            .isNull());
                })
                .run();
        assertThat(refused).hasSize(3).allSatisfy(one -> assertThat(one)
                .isInstanceOf(InputException.class)
                .hasMessageContaining("commanded by the thread 'elsewhere', but only '")
                .hasMessageContaining("', which runs the scene, may steer: give commands in events of its simulator"));
        assertThat(refused.get(2)).hasMessageStartingWith("drone 'hunter' at 0.75 s: ");
        assertThat(runs.get(0).drone("hunter").state(1.0).position().z())
                .as("refused commands change nothing")
                .isEqualTo(Pursuit.START.z() + 0.25);
        assertThatThrownBy(() -> runs.get(0).drone("hunter").fly(EAST))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("the run is over");
    }

    /** What an action on another thread throws; null if nothing. */
    private static Throwable elsewhere(Runnable action) {
        CompletableFuture<Throwable> outcome = new CompletableFuture<>();
        Thread thread = new Thread(
                () -> {
                    try {
                        action.run();
                        outcome.complete(null);
                    } catch (RuntimeException e) {
                        outcome.complete(e);
                    }
                },
                "elsewhere");
        thread.start();
        return outcome.join();
    }

    @Test
    void whatComesAfterTheEndIsLeftOutWithAWarning() {
        List<String> notes = new ArrayList<>();
        List<Double> done = new ArrayList<>();
        deaf(new Pursuit() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    protected void build() {
                        super.build();
                        sweep("sensors.camera.width", 320, 640);
                    }
                })
                .pilot(() -> run -> {
                    run.after(25.0, () -> done.add(25.0));
                    run.after(30.0, () -> done.add(30.0));
                    run.after(Pursuit.DURATION, () -> done.add(run.time()));
                })
                .notes(notes::add)
                .run();
        assertThat(done).containsExactly(Pursuit.DURATION, Pursuit.DURATION);
        assertThat(notes.stream().filter(note -> note.contains("pilot")))
                .containsExactly(
                        "warning: the pilot schedules 2 actions, the first at 25.0 s, after the end of the run at"
                                + " 6.0 s: they have no effect");
    }

    /** An action that schedules itself again ends with the run, and that is what it is meant to do. */
    @Test
    void anActionThatSchedulesItselfAgainIsNoMistake() {
        List<String> notes = new ArrayList<>();
        deaf(new Pursuit()).notes(notes::add).until(1.0).run();
        assertThat(notes).noneMatch(note -> note.contains("pilot"));
    }

    @Test
    void withoutARunThereIsNoDroneToCommand() {
        assertThatIllegalStateException()
                .isThrownBy(() -> new Pursuit().drone("hunter"))
                .withMessageContaining("the scene is not running");
    }

    @Test
    void withoutAPilotNothingIsRun() {
        FlightPathSettings steered =
                new Pursuit().describe().drones().get("hunter").flight();
        SceneRunner runner = new SceneRunner(new Pursuit(steered)).pilot(() -> Pilot.NONE);
        assertThatThrownBy(runner::run)
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "drones.hunter.flight: is steered, but no pilot steers 'hunter': set a pilot with");
    }
}
