package org.dronewatch.viewer.run;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.canvas.SensorMark;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;

/**
 * The layout of a run's sensors as changed by the user, with the most recent moves, which can be undone and redone. For
 * the event thread.
 */
public final class SensorLayout {
    /** The number of moves that can be undone. */
    private static final int MOST_KEPT = 100;

    private final List<Runnable> listeners = new ArrayList<>();
    private final Deque<SceneSettings> before = new ArrayDeque<>();
    private final Deque<SceneSettings> undone = new ArrayDeque<>();
    private SceneSettings original;
    private SceneSettings settings;

    /** The layout as it was last written to a file, or as the scene has it. */
    private SceneSettings saved;

    /** The settings saved last, if those of the next run have not been saved; otherwise null. */
    private SceneSettings begin;

    /** Takes the settings of another run, in which nothing has been moved yet. */
    public void show(SceneSettings next) {
        original = next;
        settings = next;
        saved = begin == null ? next : begin;
        before.clear();
        undone.clear();
    }

    /** Adds a listener that is run whenever a sensor has been moved, turned or changed otherwise. */
    public void listen(Runnable listener) {
        listeners.add(listener);
    }

    /** Whether there is a run. */
    public boolean isThere() {
        return settings != null;
    }

    /** The settings of the run with the sensors as they are now; null before there is a run. */
    public SceneSettings settings() {
        return settings;
    }

    /** The layout most recently written to a file, or that of the scene if none was written. */
    public SceneSettings saved() {
        return saved;
    }

    /**
     * Sets the settings with which the sensors of later runs are compared: those that differ have unsaved changes.
     *
     * @param inFile the most recently saved settings, or those of the scene that was opened if none were saved
     */
    public void beginWith(SceneSettings inFile) {
        begin = inFile;
    }

    /** Records that the current layout has been written to a file. */
    public void markSaved() {
        saved = settings;
    }

    /**
     * The sensors that differ from those saved most recently; none if the layout is that of the scene that was opened.
     */
    public Set<String> unsaved() {
        boolean isInFile =
                !isThere() || changedFrom(begin == null ? original : begin).isEmpty();
        return isInFile ? Set.of() : changedFrom(saved);
    }

    /** Remembers the layout: a single undo restores it. */
    public void remember() {
        if (before.isEmpty() || before.peek() != settings) {
            before.push(settings);
            if (before.size() > MOST_KEPT) {
                before.removeLast();
            }
        }
    }

    /** Replaces a sensor. */
    public void set(String id, SensorSettings<?> sensor) {
        settings = settings.withSensor(id, sensor);
        undone.clear();
        listeners.forEach(Runnable::run);
    }

    /** Whether there is a move that can be undone. */
    public boolean isUndoable() {
        return before.stream().anyMatch(last -> !last.sensors().equals(settings.sensors()));
    }

    /** Undoes the last move; returns whether there was one. */
    public boolean undo() {
        while (!before.isEmpty()) {
            SceneSettings last = before.pop();
            if (!last.sensors().equals(settings.sensors())) {
                undone.push(settings);
                settings = last;
                listeners.forEach(Runnable::run);
                return true;
            }
        }
        return false;
    }

    /** Whether there is a move that was undone and can be redone. */
    public boolean isRedoable() {
        return !undone.isEmpty();
    }

    /** Redoes the move that was undone last; returns whether there was one. */
    public boolean redo() {
        if (undone.isEmpty()) {
            return false;
        }
        before.push(settings);
        settings = undone.pop();
        listeners.forEach(Runnable::run);
        return true;
    }

    /** Resets all sensors to those of the scene; this can be undone. */
    public void reset() {
        if (isThere() && !moved().isEmpty()) {
            remember();
            settings = original;
            undone.clear();
            listeners.forEach(Runnable::run);
        }
    }

    /** The sensors that differ from the scene: moved, turned, or with other settings. */
    public Set<String> moved() {
        return changedFrom(original);
    }

    private Set<String> changedFrom(SceneSettings other) {
        Set<String> moved = new LinkedHashSet<>();
        settings.sensors().forEach((id, sensor) -> {
            if (!sensor.equals(other.sensors().get(id))) {
                moved.add(id);
            }
        });
        return moved;
    }

    /**
     * The recorded state of the site with the sensors as they are now. If any have been moved, these are shown without
     * detections, and the note is appended to the title.
     */
    public SiteState in(SiteState recorded, String note) {
        Set<String> moved = moved();
        if (moved.isEmpty()) {
            return recorded;
        }
        List<SensorMark> marks = recorded.sensors().stream()
                .map(mark -> moved.contains(mark.id())
                        ? mark(mark, settings.sensors().get(mark.id()))
                        : mark)
                .toList();
        return recorded.withSensors(marks, recorded.title() + note);
    }

    private static SensorMark mark(SensorMark before, SensorSettings<?> sensor) {
        return new SensorMark(before.id(), before.kind(), sensor.position(), Outlined.outline(sensor), false);
    }
}
