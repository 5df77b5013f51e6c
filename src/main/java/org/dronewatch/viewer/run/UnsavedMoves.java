package org.dronewatch.viewer.run;

import java.awt.Component;
import java.util.Set;
import java.util.function.Function;
import javax.swing.JOptionPane;

/** Asks the user before unsaved moves of sensors are lost. For the event thread. */
public final class UnsavedMoves {
    private final SensorLayout layout;
    private final Runnable saving;
    private final Function<Set<String>, Answer> question;

    /** What the user wants to do with unsaved moves. */
    public enum Answer {
        /** Write a scene file. */
        SAVE("Save scene as ..."),
        /** Discard the moves. */
        DISCARD("Discard the changes"),
        /** Keep the scene open. */
        STAY("Cancel");

        private final String label;

        Answer(String label) {
            this.label = label;
        }
    }

    /**
     * The moves of a scene.
     *
     * @param saving asks for a file and writes the scene
     * @param question asks the user what to do with the moves of some sensors
     */
    public UnsavedMoves(SensorLayout layout, Runnable saving, Function<Set<String>, Answer> question) {
        this.layout = layout;
        this.saving = saving;
        this.question = question;
    }

    /** Whether the scene may be left: nothing is lost, or the user agrees to lose it. */
    public boolean mayLeave() {
        Set<String> moved = layout.unsaved();
        if (moved.isEmpty()) {
            return true;
        }
        Answer answer = question.apply(moved);
        if (answer == Answer.SAVE) {
            saving.run();
        }
        return answer == Answer.DISCARD || layout.unsaved().isEmpty();
    }

    /** Asks in a dialog. */
    public static Answer ask(Component parent, Set<String> moved) {
        Object[] labels = {Answer.SAVE.label, Answer.DISCARD.label, Answer.STAY.label};
        int chosen = JOptionPane.showOptionDialog(
                parent,
                words(moved),
                "Unsaved changes to sensors",
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.WARNING_MESSAGE,
                null,
                labels,
                labels[0]);
        return chosen == JOptionPane.CLOSED_OPTION ? Answer.STAY : Answer.values()[chosen];
    }

    /** What would be lost: {@code 'radar' and 2 other sensors were changed, and ...} */
    public static String words(Set<String> moved) {
        String first = "'" + moved.iterator().next() + "'";
        int others = moved.size() - 1;
        String all = others == 0
                ? first + " was"
                : first + " and " + others + " other sensor" + (others == 1 ? "" : "s") + " were";
        return all + " changed, and the scene has not been saved since.";
    }
}
