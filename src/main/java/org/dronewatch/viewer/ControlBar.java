package org.dronewatch.viewer;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntConsumer;
import javax.swing.Action;
import javax.swing.Box;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JToolBar;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.run.Playback;
import org.dronewatch.viewer.run.RecordedRun;

/** The tool bar for playback: play, pause, step, speed, the run of a sweep, and the time. */
final class ControlBar extends JToolBar {
    private static final long serialVersionUID = 1L;
    private static final String PLAY = "\u25b6";
    private static final String PAUSE = "\u275a\u275a";

    private final transient Playback playback;
    private final JButton play;
    private final transient Action playAction;
    private final JComboBox<String> speed = new JComboBox<>();
    private final JComboBox<String> runs = new JComboBox<>();
    private final JLabel time = new JLabel("0.00 s");
    private final JLabel state = new JLabel("");
    private final transient IntConsumer runChosen;
    private boolean updating;

    /**
     * A bar.
     *
     * @param runChosen receives the run that the user wants to see
     */
    ControlBar(Playback playback, ViewerActions actions, IntConsumer runChosen) {
        this.playback = playback;
        this.runChosen = runChosen;
        this.playAction = actions.play();
        setFloatable(false);
        symbol(actions.toStart(), "|\u25c0\u25c0");
        symbol(actions.stepBack(), "|\u25c0");
        play = symbol(playAction, PLAY);
        symbol(actions.stepOn(), "\u25b6|");
        symbol(actions.toEnd(), "\u25b6\u25b6|");
        addSeparator();
        for (double factor : Playback.SPEEDS) {
            speed.addItem(Texts.speed(factor));
        }
        speed.setSelectedIndex(3);
        speed.setMaximumSize(Scaled.size(190, 40));
        speed.setToolTipText("Playback speed, as a multiple of real time");
        speed.getAccessibleContext().setAccessibleName("speed");
        speed.addActionListener(e -> {
            if (!updating) {
                playback.setSpeed(Playback.SPEEDS.get(speed.getSelectedIndex()));
            }
        });
        add(speed);
        addSeparator();
        runs.setMaximumSize(Scaled.size(330, 40));
        runs.setToolTipText("Selects the displayed run of the sweep");
        runs.getAccessibleContext().setAccessibleName("run");
        runs.setVisible(false);
        runs.addActionListener(e -> {
            if (!updating && runs.getSelectedIndex() >= 0) {
                this.runChosen.accept(runs.getSelectedIndex());
            }
        });
        add(runs);
        add(Box.createHorizontalGlue());
        add(state);
        add(Box.createHorizontalStrut(Scaled.px(16)));
        time.setFont(time.getFont().deriveFont(time.getFont().getSize2D() * 1.25f));
        time.setToolTipText("Time since the start of the run");
        add(time);
        add(Box.createHorizontalStrut(Scaled.px(12)));
    }

    /** A button that shows a symbol in place of the action's name. */
    private JButton symbol(Action action, String symbol) {
        JButton button = add(action);
        button.setText(symbol);
        button.setFocusable(false);
        button.getAccessibleContext().setAccessibleName((String) action.getValue(Action.NAME));
        return button;
    }

    /** Updates the display. */
    void update(List<RecordedRun> known) {
        updating = true;
        if (known.size() != runs.getItemCount()) {
            int selected = Math.max(0, known.indexOf(playback.run()));
            List<String> names = new ArrayList<>();
            known.forEach(run -> names.add(name(run)));
            runs.setModel(new DefaultComboBoxModel<>(names.toArray(String[]::new)));
            runs.setSelectedIndex(selected < names.size() ? selected : -1);
            runs.setVisible(known.size() > 1);
        } else if (playback.run() != null && runs.getSelectedIndex() != known.indexOf(playback.run())) {
            runs.setSelectedIndex(known.indexOf(playback.run()));
        }
        for (int i = 0; i < Playback.SPEEDS.size(); i++) {
            if (Playback.SPEEDS.get(i) == playback.speed() && speed.getSelectedIndex() != i) {
                speed.setSelectedIndex(i);
            }
        }
        updating = false;
        playAction.putValue(Action.NAME, playback.isPlaying() ? "Pause" : "Play");
        play.setText(playback.isPlaying() ? PAUSE : PLAY);
        RecordedRun run = playback.run();
        if (run != null) {
            time.setText(Texts.time(playback.time()) + " of " + Texts.time(run.duration()));
            state.setText(
                    run.isFinished()
                            ? ""
                            : String.format(Locale.ROOT, "simulated up to %s ...", Texts.time(run.reached())));
        }
    }

    /** The name of a run of a sweep, with its value. */
    static String name(RecordedRun run) {
        String number = "run " + run.info().run();
        return run.info()
                .settings()
                .sweep()
                .map(sweep -> number + ": " + new SweptValue(run.info().settings(), sweep).shortText())
                .orElse(number);
    }
}
