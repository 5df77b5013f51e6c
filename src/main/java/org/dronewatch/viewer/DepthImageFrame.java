package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.HeadlessException;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.camera.CameraSensor;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.world.World;

/**
 * A window for your own program that shows the image of a camera: distances in shades of blue, darker for shorter ones,
 * drones in orange. It needs no scene. Closing it does not end the program.
 *
 * <pre>{@code
 * DepthImageFrame frame = new DepthImageFrame("gate");
 * for (double time = 0.0; time < 30.0; time += 0.1) {
 *     frame.show(camera, world, List.of(drone = drone.move(step)));
 * }
 * }</pre>
 */
public final class DepthImageFrame extends JFrame {
    private static final long serialVersionUID = 1L;
    private static final Color BORDER = new Color(0x10141a);

    /** Larger images are scaled down to this, pixels. */
    private static final int LARGEST = 900;

    private final Canvas canvas = new Canvas();

    /**
     * Creates an empty window, which stays hidden until the first image is shown.
     *
     * @throws HeadlessException where there is no display
     */
    public DepthImageFrame(String title) {
        super(title);
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        add(canvas);
    }

    /**
     * Takes an image with a camera and shows it; the first image makes the window visible. For the thread that uses the
     * camera.
     *
     * @param camera one thread at a time may use it
     */
    public void show(CameraSensor camera, World world, List<Drone> drones) {
        show(camera.depthImage(world, drones));
    }

    /** Shows an image, from any thread. */
    public void show(DepthImage image) {
        BufferedImage picture = image.toImage();
        SwingUtilities.invokeLater(() -> {
            canvas.show(picture);
            if (!isVisible()) {
                pack();
                setVisible(true);
            }
        });
    }

    /** The image as large as fits, without distortion. */
    static final class Canvas extends JPanel {
        private static final long serialVersionUID = 1L;
        private transient BufferedImage picture;

        Canvas() {
            setBackground(BORDER);
        }

        void show(BufferedImage next) {
            picture = next;
            double scale = Math.min(1.0, LARGEST / (double) Math.max(next.getWidth(), next.getHeight()));
            setPreferredSize(
                    new Dimension((int) Math.ceil(scale * next.getWidth()), (int) Math.ceil(scale * next.getHeight())));
            repaint();
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            super.paintComponent(graphics);
            if (picture == null) {
                return;
            }
            double scale =
                    Math.min(getWidth() / (double) picture.getWidth(), getHeight() / (double) picture.getHeight());
            int width = (int) Math.round(scale * picture.getWidth());
            int height = (int) Math.round(scale * picture.getHeight());
            graphics.drawImage(picture, (getWidth() - width) / 2, (getHeight() - height) / 2, width, height, null);
        }
    }
}
