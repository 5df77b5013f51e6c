package org.dronewatch.viewer.gallery;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.WrappedText;

/** A packaged scene: a button with its picture and name, and below it a sentence on what the scene shows. */
final class SceneCard extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Width of the picture, in pixels of a screen of normal density. */
    private static final int WIDTH = 320;

    private static final float NAME_SIZE = 1.15f;

    /** Lines of text for which there is room below the picture. */
    private static final int LINES = 3;

    private final JButton button;

    /**
     * A card.
     *
     * @param chosen called when the user chooses the scene
     */
    SceneCard(PackagedScene scene, BufferedImage picture, Runnable chosen) {
        super(new BorderLayout(0, Scaled.px(2)));
        String sentence = sentence(scene.summary());
        button = new JButton(scene.name(), new Picture(picture));
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setIconTextGap(Scaled.px(6));
        button.setFont(Scaled.font(NAME_SIZE).deriveFont(Font.BOLD));
        button.setToolTipText("Opens this scene");
        button.getAccessibleContext().setAccessibleDescription(sentence);
        button.addActionListener(e -> chosen.run());
        bind(KeyEvent.VK_ENTER, () -> button.doClick(0));
        WrappedText text = new WrappedText("description of the scene " + scene.name());
        text.setText(sentence);
        text.setBorder(BorderFactory.createEmptyBorder(0, Scaled.px(4), 0, Scaled.px(4)));
        int lineHeight = text.getFontMetrics(text.getFont()).getHeight();
        text.setPreferredSize(new Dimension(Scaled.px(WIDTH), LINES * lineHeight));
        text.setCursor(Cursor.getDefaultCursor());
        text.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                button.doClick(0);
            }
        });
        add(button, BorderLayout.CENTER);
        add(text, BorderLayout.SOUTH);
    }

    /** A summary, as lists show it, in the form of a sentence. */
    static String sentence(String summary) {
        return Character.toUpperCase(summary.charAt(0)) + summary.substring(1) + ".";
    }

    /** Sets what a key does while the card has the focus. */
    void bind(int key, Runnable work) {
        String name = KeyEvent.getKeyText(key);
        button.getInputMap().put(KeyStroke.getKeyStroke(key, 0), name);
        button.getActionMap().put(name, new AbstractAction() {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(java.awt.event.ActionEvent e) {
                work.run();
            }
        });
    }

    JButton button() {
        return button;
    }

    private record Picture(BufferedImage image) implements Icon {
        @Override
        public void paintIcon(Component owner, Graphics g, int x, int y) {
            Graphics2D fine = (Graphics2D) g.create();
            fine.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
            fine.drawImage(image, x, y, getIconWidth(), getIconHeight(), null);
            fine.dispose();
        }

        @Override
        public int getIconWidth() {
            return Scaled.px(WIDTH);
        }

        @Override
        public int getIconHeight() {
            return Scaled.px(WIDTH * image.getHeight() / image.getWidth());
        }
    }
}
