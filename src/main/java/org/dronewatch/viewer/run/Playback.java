package org.dronewatch.viewer.run;

import java.util.ArrayList;
import java.util.List;

/**
 * The displayed time of a recorded run. It advances by itself during playback, as far as the run has been simulated.
 * For use by one thread.
 */
public final class Playback {
    /** Playback speeds to choose from, as multiples of real time; the last, infinity, is as fast as possible. */
    public static final List<Double> SPEEDS =
            List.of(0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, Double.POSITIVE_INFINITY);

    private final List<Runnable> listeners = new ArrayList<>();
    private RecordedRun run;
    private double time;
    private double speed = 1.0;
    private boolean playing;
    private double step = 0.1;

    /** Adds a listener that is run whenever something has changed. */
    public void listen(Runnable listener) {
        listeners.add(listener);
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    /** Shows another run, from its start. */
    public void show(RecordedRun other) {
        run = other;
        time = 0.0;
        double fastest = other.info().settings().enabledSensors().values().stream()
                .mapToDouble(sensor -> sensor.rate())
                .max()
                .orElse(10.0);
        step = 1.0 / fastest;
        changed();
    }

    /** The displayed run, or null if there is none yet. */
    public RecordedRun run() {
        return run;
    }

    /** The time shown, s. */
    public double time() {
        return time;
    }

    /** The playback speed as a multiple of real time; infinite for as fast as possible. */
    public double speed() {
        return speed;
    }

    public boolean isPlaying() {
        return playing;
    }

    /** Sets the playback speed, as {@link #speed} returns it. */
    public void setSpeed(double factor) {
        speed = factor;
        changed();
    }

    /** Resumes playback, from the start if the end of the run has been reached. */
    public void play() {
        if (run != null && time >= run.duration()) {
            time = 0.0;
        }
        playing = true;
        changed();
    }

    public void pause() {
        playing = false;
        changed();
    }

    /**
     * Pauses, and steps by a number of looks of the sensor with the highest rate, backwards if the number is negative.
     */
    public void step(int looks) {
        playing = false;
        // The time goes from look to look, wherever between two looks it was.
        double number = looks > 0 ? Math.floor(time / step + 1e-6) : Math.ceil(time / step - 1e-6);
        jump((number + looks) * step);
    }

    /** Shows another time, but none beyond the end of what has been simulated so far. */
    public void jump(double to) {
        if (run != null) {
            time = Math.max(0.0, Math.min(run.reached(), to));
            changed();
        }
    }

    /** Advances the playback, if it is not paused, by a duration of real time, s. */
    public void advance(double seconds) {
        if (!playing || run == null) {
            return;
        }
        time = Math.min(run.reached(), speed == Double.POSITIVE_INFINITY ? run.reached() : time + speed * seconds);
        if (run.isFinished() && time >= run.duration()) {
            playing = false;
        }
        changed();
    }
}
