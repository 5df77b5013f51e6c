package org.dronewatch.viewer;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import org.dronewatch.viewer.run.Playback;

/** The user's actions on a run's time, with name, key and explanation: the same in bars and menus. */
final class ViewerActions {
    private final Action play;
    private final Action stepOn;
    private final Action stepBack;
    private final Action toStart;
    private final Action toEnd;
    private final Action faster;
    private final Action slower;

    ViewerActions(Playback playback) {
        play = action("Play", "Plays or pauses the run", key(KeyEvent.VK_SPACE), () -> {
            if (playback.isPlaying()) {
                playback.pause();
            } else {
                playback.play();
            }
        });
        stepOn = action(
                "Step forward", "Pauses and steps to the next look", key(KeyEvent.VK_PERIOD), () -> playback.step(1));
        stepBack = action(
                "Step back", "Pauses and steps to the previous look", key(KeyEvent.VK_COMMA), () -> playback.step(-1));
        toStart = action("Go to start", "Jumps to the start", key(KeyEvent.VK_HOME), () -> playback.jump(0.0));
        toEnd = action(
                "Go to end",
                "Jumps to the end of the simulated part",
                key(KeyEvent.VK_END),
                () -> playback.jump(Double.MAX_VALUE));
        faster = action("Faster", "Plays faster", key(KeyEvent.VK_PLUS), () -> change(playback, 1));
        slower = action("Slower", "Plays slower", key(KeyEvent.VK_MINUS), () -> change(playback, -1));
    }

    private static void change(Playback playback, int by) {
        int now = 0;
        while (Playback.SPEEDS.get(now) < playback.speed()) {
            now++;
        }
        playback.setSpeed(Playback.SPEEDS.get(Math.max(0, Math.min(Playback.SPEEDS.size() - 1, now + by))));
    }

    /** An action with a name, an explanation, and a key that menus show. */
    static Action action(String name, String explanation, KeyStroke key, Runnable work) {
        Action action = new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                work.run();
            }
        };
        action.putValue(Action.SHORT_DESCRIPTION, explanation);
        action.putValue(Action.ACCELERATOR_KEY, key);
        return action;
    }

    /** A key without modifiers. */
    static KeyStroke key(int code) {
        return KeyStroke.getKeyStroke(code, 0);
    }

    /** A key with the system's modifier for menu shortcuts. */
    static KeyStroke menuKey(int code) {
        return KeyStroke.getKeyStroke(code, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx());
    }

    /** A key with the system's modifier for menu shortcuts, and Shift. */
    static KeyStroke shiftedMenuKey(int code) {
        return KeyStroke.getKeyStroke(
                code, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx() | InputEvent.SHIFT_DOWN_MASK);
    }

    Action play() {
        return play;
    }

    Action stepOn() {
        return stepOn;
    }

    Action stepBack() {
        return stepBack;
    }

    Action toStart() {
        return toStart;
    }

    Action toEnd() {
        return toEnd;
    }

    Action faster() {
        return faster;
    }

    Action slower() {
        return slower;
    }
}
