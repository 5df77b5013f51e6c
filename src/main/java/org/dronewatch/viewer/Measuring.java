package org.dronewatch.viewer;

import java.awt.Graphics2D;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.survey.LineOfSight;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.tape.Tape;
import org.dronewatch.viewer.tape.TapePainter;
import org.dronewatch.viewer.tape.TapeReading;

/**
 * Measures between two points of the site that the user clicks on, or between selected sensors and drones. The tape
 * stays where it is when sensors or drones move. For the event thread.
 */
final class Measuring implements WorldTool, AutoCloseable {
    private static final String BEGIN =
            "Measuring: click on a point, a sensor or a drone, or press Shift+M for the selected one; Escape ends"
                    + " measuring";

    private final WorldPanel world;
    private final Function<String, Optional<Position>> places;
    private final Consumer<String> status;
    private final Consumer<String> log;
    private final Latest thread;
    private final TapePainter painter;
    private Optional<Stage> stage = Optional.empty();
    private boolean isOn;
    private Optional<Tape.End> first = Optional.empty();
    private Optional<Tape.End> pointer = Optional.empty();
    private Optional<Tape> tape = Optional.empty();
    private Optional<TapeReading> reading = Optional.empty();

    /** The lines of sight of a stage; only the thread uses them. */
    private Stage traced;

    private LineOfSight sight;

    /**
     * Measures nothing yet.
     *
     * @param places where the sensor or drone with a given name is now, m
     * @param status receives what is measured
     * @param log receives each reading
     * @param failed receives what went wrong
     */
    Measuring(
            WorldPanel world,
            Function<String, Optional<Position>> places,
            Consumer<String> status,
            Consumer<String> log,
            Consumer<Throwable> failed) {
        this.world = world;
        this.places = places;
        this.status = status;
        this.log = log;
        this.thread = new Latest("dronewatch-tape", 1, failed);
        this.painter = new TapePainter(world::pixelOf);
    }

    /** Takes the site of another run; what was measured before is discarded. */
    void show(Stage other) {
        stage = Optional.of(other);
        end();
    }

    /** Begins to measure, or ends it. */
    void toggle() {
        if (!end() && stage.isPresent()) {
            isOn = true;
            status.accept(BEGIN);
        }
    }

    /** Ends measuring; returns whether something was being measured. */
    boolean end() {
        boolean was = isOn;
        isOn = false;
        clear();
        if (was) {
            status.accept("Measuring ended");
        }
        world.repaint();
        return was;
    }

    private void clear() {
        first = Optional.empty();
        pointer = Optional.empty();
        tape = Optional.empty();
        reading = Optional.empty();
    }

    /** Puts an end of the tape at a sensor or drone; begins to measure if need be. */
    void put(Optional<String> id) {
        if (stage.isEmpty()) {
            return;
        }
        isOn = true;
        id.flatMap(this::endAt)
                .ifPresentOrElse(
                        this::put,
                        () -> status.accept(
                                "Select a sensor or a drone first: click on its symbol, or choose a row of a"
                                        + " table"));
    }

    private Optional<Tape.End> endAt(String id) {
        return places.apply(id).map(place -> Tape.End.of(id, place));
    }

    @Override
    public boolean isOn() {
        return isOn;
    }

    @Override
    public void click(int x, int y) {
        endAt(x, y)
                .ifPresentOrElse(
                        this::put, () -> status.accept("No surface there: click on the site, a sensor or a drone"));
    }

    /** The sensor or drone at a pixel, otherwise the point of a surface. */
    private Optional<Tape.End> endAt(int x, int y) {
        return world.symbolAt(x, y).flatMap(this::endAt).or(() -> world.placeAt(x, y)
                .map(place -> Tape.End.onSurface(place, world.eye())));
    }

    private void put(Tape.End end) {
        if (first.isEmpty() || tape.isPresent()) {
            clear();
            first = Optional.of(end);
            status.accept(
                    "Measuring from " + end.name() + " at " + Texts.place(end.place()) + ": click on the other point");
        } else {
            read(new Tape(first.get(), end));
        }
        world.repaint();
    }

    private void read(Tape next) {
        tape = Optional.of(next);
        Stage here = stage.orElseThrow();
        thread.ask(outdated -> {
            if (traced != here) {
                traced = here;
                sight = new LineOfSight(here);
            }
            TapeReading found = TapeReading.of(next, sight);
            SwingUtilities.invokeLater(() -> {
                if (tape.filter(one -> one == next).isPresent()) {
                    take(found);
                }
            });
        });
    }

    private void take(TapeReading found) {
        reading = Optional.of(found);
        status.accept(found.words());
        log.accept(found.words());
        world.getAccessibleContext().setAccessibleDescription(found.words());
        world.repaint();
    }

    @Override
    public Optional<String> hint(int x, int y) {
        if (tape.isPresent()) {
            return reading.map(TapeReading::words);
        }
        if (first.isEmpty()) {
            return Optional.empty();
        }
        pointer = endAt(x, y);
        world.repaint();
        return pointer.map(end -> TapeReading.wordsOf(new Tape(first.get(), end)));
    }

    @Override
    public void paint(Graphics2D g) {
        tape.or(() -> first.map(from -> new Tape(from, pointer.orElse(from))))
                .ifPresent(shown -> painter.paint(g, shown, reading));
    }

    /** What the tape shows; empty until it has been read. */
    Optional<TapeReading> reading() {
        return reading;
    }

    boolean isIdle() {
        return thread.isIdle() && (tape.isEmpty() || reading.isPresent());
    }

    @Override
    public void close() {
        thread.close();
    }
}
