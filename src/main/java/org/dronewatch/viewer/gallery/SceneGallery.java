package org.dronewatch.viewer.gallery;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.GridLayout;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.viewer.part.Notice;
import org.dronewatch.viewer.part.Scaled;

/**
 * The packaged scenes as cards, and a button for scene files. Tab and the arrow keys move between cards, Enter or Space
 * opens the scene.
 */
public final class SceneGallery extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int COLUMNS = 2;
    private static final int GAP = 12;

    private final transient List<SceneCard> cards;
    private final JButton file = new JButton("Open a scene file ...");
    private final Notice notice = new Notice();

    /**
     * A gallery.
     *
     * @param chosen receives the scene that the user chooses
     * @param fileChosen called when the user wants to open a scene file
     */
    public SceneGallery(ScenePictures pictures, Consumer<PackagedScene> chosen, Runnable fileChosen) {
        super(new BorderLayout());
        cards = PackagedScene.all().stream()
                .map(scene -> new SceneCard(scene, pictures.byName().get(scene.name()), () -> chosen.accept(scene)))
                .toList();
        int gap = Scaled.px(GAP);
        JPanel grid = new JPanel(new GridLayout(0, COLUMNS, gap, gap));
        grid.setBorder(BorderFactory.createEmptyBorder(gap, gap, gap, gap));
        for (int i = 0; i < cards.size(); i++) {
            grid.add(cards.get(i));
            bindArrows(i);
        }
        JScrollPane scrolling = new JScrollPane(grid);
        scrolling.setBorder(null);
        scrolling.getVerticalScrollBar().setUnitIncrement(gap);
        file.setToolTipText("Opens your own scene file (YAML)");
        file.addActionListener(e -> fileChosen.run());
        JPanel below = new JPanel(new FlowLayout(FlowLayout.TRAILING, gap, gap));
        below.add(file);
        add(notice, BorderLayout.NORTH);
        add(scrolling, BorderLayout.CENTER);
        add(below, BorderLayout.SOUTH);
        getAccessibleContext().setAccessibleName("packaged scenes");
    }

    private void bindArrows(int number) {
        SceneCard card = cards.get(number);
        card.bind(KeyEvent.VK_LEFT, () -> focus(number - 1));
        card.bind(KeyEvent.VK_RIGHT, () -> focus(number + 1));
        card.bind(KeyEvent.VK_UP, () -> focus(number - COLUMNS));
        card.bind(KeyEvent.VK_DOWN, () -> focus(number + COLUMNS));
    }

    private void focus(int number) {
        if (number >= 0 && number < cards.size()) {
            cards.get(number).button().requestFocusInWindow();
        }
    }

    /** Gives the focus to the first card. */
    public void begin() {
        focus(0);
    }

    /** The buttons of the cards, in the order of the packaged scenes. */
    public List<JButton> buttons() {
        return cards.stream().map(SceneCard::button).toList();
    }

    /** Shows why a scene could not be opened. */
    public void report(String problem) {
        notice.show(problem);
    }

    /** What is reported; empty before the first problem. */
    public String reported() {
        return notice.text();
    }
}
