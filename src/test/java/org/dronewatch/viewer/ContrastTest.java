package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Color;
import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.LookAndFeel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.run.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** All texts of the viewer can be read: level AA of WCAG 2.1 asks for a contrast of 4.5 (success criterion 1.4.3). */
class ContrastTest {
    private static final double AA = 4.5;

    @TempDir
    private Path directory;

    @Thorough
    @ParameterizedTest(name = "dark {0}")
    @ValueSource(booleans = {false, true})
    void allTextsHaveEnoughContrast(boolean dark) throws Exception {
        LookAndFeel before = UIManager.getLookAndFeel();
        onEventThread(() -> {
            ViewerWindow.setLook(dark);
            return null;
        });
        Recording recording = new Recording();
        new SceneRunner(new Yard(directory))
                .set("run.duration", "1 s")
                .listener(recording)
                .run();
        recording.finish(true);
        ViewerPane pane = onEventThread(() -> new ViewerPane("yard", recording, 2, settings -> LayerStore.NONE));
        try {
            onEventThread(() -> {
                // As if it were in a window: tables get their headers, and all is laid out anew when it changes.
                pane.addNotify();
                pane.setSize(1280, 740);
                return null;
            });
            await("the run", () -> isDrawn(pane));
            onEventThread(() -> {
                pane.coverage().form().set("2, 6", "40", "4");
                pane.showCoverage();
                return null;
            });
            await("the coverage", () -> isDrawn(pane) && pane.coverage().shown().isPresent());
            List<String> faint = new ArrayList<>();
            int texts = 0;
            List<JTabbedPane> tabs = onEventThread(() -> Parts.in(pane)
                    .filter(JTabbedPane.class::isInstance)
                    .map(JTabbedPane.class::cast)
                    .toList());
            assertThat(tabs).isNotEmpty();
            for (JTabbedPane some : tabs) {
                for (int tab = 0; tab < some.getTabCount(); tab++) {
                    int chosen = tab;
                    await("the picture", () -> {
                        some.setSelectedIndex(chosen);
                        return isDrawn(pane);
                    });
                    texts += onEventThread(() -> faintTexts(pane, faint));
                }
            }
            assertThat(texts).isGreaterThan(200);
            assertThat(faint.stream().distinct()).isEmpty();
        } finally {
            pane.close();
            onEventThread(() -> {
                UIManager.setLookAndFeel(before);
                return null;
            });
        }
    }

    /** Lets the pane work. */
    private static boolean isDrawn(ViewerPane pane) {
        pane.tick(0.2);
        pane.validate();
        return pane.viewed().isPresent() && pane.isIdle();
    }

    /** Adds texts with too little contrast, but for those of controls that are disabled; the number of texts. */
    private static int faintTexts(ViewerPane pane, List<String> faint) {
        BufferedImage image = new BufferedImage(pane.getWidth(), pane.getHeight(), BufferedImage.TYPE_INT_RGB);
        TextGraphics graphics = new TextGraphics(image);
        graphics.setClip(0, 0, image.getWidth(), image.getHeight());
        pane.print(graphics);
        for (TextGraphics.Text text : graphics.texts()) {
            Component part = SwingUtilities.getDeepestComponentAt(
                    pane, (int) text.at().getCenterX(), (int) text.at().getCenterY());
            if (text.contrast() < AA && (part == null || part.isEnabled() || part instanceof JLabel)) {
                faint.add(String.format(
                        Locale.ROOT,
                        "%.2f %s '%s' %s",
                        text.contrast(),
                        part == null ? "?" : part.getClass().getSimpleName(),
                        text.text(),
                        Integer.toHexString(text.colour().getRGB())));
            }
        }
        return graphics.texts().size();
    }

    /** Black on white has 21; #767676 is the lightest grey with 4.5 on white, as stated with the criterion. */
    @Test
    void theContrastIsThatOfTheGuidelines() {
        assertThat(TextGraphics.contrast(Color.BLACK, Color.WHITE)).isEqualTo(21.0);
        assertThat(TextGraphics.contrast(new Color(0x767676), Color.WHITE)).isBetween(4.5, 4.6);
        assertThat(TextGraphics.contrast(new Color(0x777777), Color.WHITE)).isLessThan(4.5);
    }
}
