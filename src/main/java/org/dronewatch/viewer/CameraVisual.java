package org.dronewatch.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.DroneFrame;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.PairReading;

/**
 * The view of one camera: distances in shades of blue, darker for shorter ones, and a pale sky. Each drone's pixels are
 * orange, its significant pixels are framed, and the number of its pixels stands beside the number required. The frame
 * of a distant drone is enlarged; in a large view, an inset in a corner shows a drone magnified. For use in your own
 * window, on the event thread like all components of Swing:
 *
 * <pre>{@code
 * CameraVisual visual = CameraVisual.of("gate", cameraSettings, stage);
 * frame.add(visual);
 * visual.showTime(12.5);
 * }</pre>
 */
public final class CameraVisual extends JPanel {
    static final Color HIT = new Color(0xff6a00);
    static final Color DETECTED = new Color(0xffd23f);
    private static final long serialVersionUID = 1L;
    private static final Color UNDETECTED = new Color(0xffffff);
    private static final Color PLATE = new Color(24, 28, 34, 190);
    private static final double PLATES = 0.88;
    private static final Color BORDER = new Color(0x10141a);

    /** The smallest frame around a drone's pixels, in pixels of the panel. */
    private static final double SMALLEST = 14.0;

    /** Pictures that are lower than this have room for the camera's name only. */
    private static final int LEGIBLE = 70;

    /** The distance of plates from the lower edge, pixels. */
    private static final int EDGE = 4;

    /** Pictures that are at least this wide have room for the magnifier. */
    private static final int LARGE = 420;

    private final transient CameraEye eye;
    private transient CameraShot shot;
    private transient Map<String, PairReading> readings = Map.of();
    private boolean selected;
    private transient Consumer<String> hint = text -> {};

    /**
     * The view of a camera on a fixed mount, for visible light or thermal; empty until {@link #showTime}.
     *
     * @param id name to be shown
     * @param sensor settings of the camera
     * @param stage world and drones
     * @throws IllegalArgumentException when the sensor takes no images
     */
    public static CameraVisual of(String id, SensorSettings<?> sensor, Stage stage) {
        if (sensor.as(PictureSettings.class).isEmpty()) {
            throw new IllegalArgumentException("sensor '" + id + "' of kind " + sensor.kind() + " takes no images");
        }
        return new CameraVisual(new CameraEye(id, sensor, stage, time -> Optional.empty()));
    }

    /**
     * Shows the camera's last frame up to a time.
     *
     * @param time seconds since the start of the run, 0 or more
     */
    public void showTime(double time) {
        Rectangle frame = frame();
        show(eye.look(time, Math.max(1, frame.width), Math.max(1, frame.height)));
    }

    CameraVisual(CameraEye eye) {
        this.eye = eye;
        setPreferredSize(Scaled.size(240, 150));
        setMinimumSize(Scaled.size(80, 50));
        setToolTipText(eye.id() + ": click to enlarge, click again for all cameras");
        getAccessibleContext().setAccessibleName("camera " + eye.id());
        addMouseMotionListener(new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                describe(e.getX(), e.getY());
            }
        });
    }

    CameraEye eye() {
        return eye;
    }

    /** Sets what receives a description of the pixel under the pointer. */
    void onHint(Consumer<String> target) {
        hint = target;
    }

    /** Shows another time. */
    void show(CameraShot next) {
        shot = next;
        repaint();
    }

    /** Shows the camera's last measurement of each drone in its image, and whether it is selected. */
    void mark(Map<String, PairReading> latest, boolean isSelected) {
        if (!readings.equals(latest) || selected != isSelected) {
            readings = latest;
            selected = isSelected;
            repaint();
        }
    }

    private boolean isDetecting() {
        return readings.values().stream().anyMatch(PairReading::isEnough);
    }

    /** The position of the image in this panel: as large as possible with the camera's aspect ratio. */
    Rectangle frame() {
        double aspect = eye.settings().width() / (double) eye.settings().height();
        int width = Math.max(1, Math.min(getWidth(), (int) Math.round(getHeight() * aspect)));
        int height = Math.max(1, Math.min(getHeight(), (int) Math.round(width / aspect)));
        return new Rectangle((getWidth() - width) / 2, (getHeight() - height) / 2, width, height);
    }

    private void describe(int x, int y) {
        Rectangle frame = frame();
        if (shot != null && frame.contains(x, y)) {
            int column = (int) ((x - frame.x + 0.5) * eye.settings().width() / frame.width);
            int row = (int) ((y - frame.y + 0.5) * eye.settings().height() / frame.height);
            hint.accept(String.format(
                    Locale.ROOT, "%s, pixel (%d, %d): %s", eye.id(), column, row, eye.describe(shot, column, row)));
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(BORDER);
        g.fillRect(0, 0, getWidth(), getHeight());
        Rectangle frame = frame();
        if (shot != null) {
            g.setRenderingHint(
                    RenderingHints.KEY_INTERPOLATION,
                    frame.width > shot.background().getWidth()
                            ? RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR
                            : RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            g.drawImage(shot.background(), frame.x, frame.y, frame.width, frame.height, null);
            for (DronePixels drone : shot.drones()) {
                drawDrone(g, frame, drone);
            }
            if (frame.width >= Scaled.px(LARGE)) {
                shot.drones().stream()
                        .filter(drone -> drone.count() > 0)
                        .findFirst()
                        .ifPresent(drone -> magnify(g, frame, drone));
            }
        }
        drawName(g, frame);
        if (isDetecting() || selected) {
            g.setColor(isDetecting() ? DETECTED : Color.WHITE);
            g.setStroke(new BasicStroke(selected ? 4f : 2.5f));
            g.drawRect(frame.x + 1, frame.y + 1, frame.width - 3, frame.height - 3);
        }
        g.dispose();
    }

    private void drawDrone(Graphics2D g, Rectangle frame, DronePixels drone) {
        if (drone.columns() == 0) {
            return;
        }
        double sx = frame.width / (double) eye.settings().width();
        double sy = frame.height / (double) eye.settings().height();
        g.setColor(HIT);
        for (int row = drone.top(); row < drone.top() + drone.rows(); row++) {
            for (int column = drone.left(); column < drone.left() + drone.columns(); column++) {
                if (!shot.inColour() && drone.isHit(column, row)) {
                    g.fill(new Rectangle2D.Double(frame.x + column * sx, frame.y + row * sy, sx, sy));
                }
            }
        }
        Rectangle2D.Double about = DroneFrame.about(
                drone, eye.settings().width(), eye.settings().height(), frame, SMALLEST * Scaled.factor());
        PairReading reading = readings.get(drone.drone());
        g.setColor(reading != null && reading.isEnough() ? DETECTED : UNDETECTED);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(about);
        if (frame.height < Scaled.px(LEGIBLE)) {
            return;
        }
        if (frame.width < Scaled.px(LARGE)) {
            // Beside the drone there would be no room.
            plate(g, frame, frame.x + 4, frame.y + 4, shortCount(drone));
        } else {
            plate(g, frame, (int) (about.x + about.width + 4), (int) about.y, count(drone));
        }
    }

    private String shortCount(DronePixels drone) {
        PairReading reading = readings.get(drone.drone());
        return reading == null ? drone.count() + " px" : reading.text();
    }

    private String count(DronePixels drone) {
        PairReading reading = readings.get(drone.drone());
        boolean inPixels = reading != null && reading.unit().equals("px");
        return drone.drone() + ": " + (inPixels ? "" : drone.count() + " px")
                + (reading == null || inPixels ? "" : ", ") + (reading == null ? "" : reading.text());
    }

    /** A text on a plate, kept inside the frame. */
    private static void plate(Graphics2D g, Rectangle frame, int x, int y, String text) {
        g.setFont(Scaled.font(PLATES));
        FontMetrics metrics = g.getFontMetrics();
        int width = metrics.stringWidth(text) + 8;
        int height = metrics.getHeight() + 2;
        int left = Math.max(frame.x, Math.min(frame.x + frame.width - width, x));
        int top = Math.max(frame.y, Math.min(frame.y + frame.height - height - EDGE, y));
        g.setColor(PLATE);
        g.fillRoundRect(left, top, width, height, 6, 6);
        g.setColor(Color.WHITE);
        g.drawString(text, left + 4, top + 1 + metrics.getAscent());
    }

    /** The camera's name; for one on a positioner also the positioner's state and the field of view. */
    String name() {
        if (shot == null || shot.pointing().isEmpty()) {
            return eye.id();
        }
        Pointing pointing = shot.pointing().get();
        String what = pointing.contact().isPresent()
                ? "follows contact " + pointing.contact().getAsInt()
                : "searches";
        return String.format(Locale.ROOT, "%s: %s, %.1f\u00b0", eye.id(), what, Math.toDegrees(pointing.fov()));
    }

    private void drawName(Graphics2D g, Rectangle frame) {
        plate(g, frame, frame.x + 4, frame.y + frame.height - 4, name());
    }

    /** The drone's pixels one by one, large, in the upper right corner. */
    private void magnify(Graphics2D g, Rectangle frame, DronePixels drone) {
        int columns = drone.columns() + 4;
        int rows = drone.rows() + 4;
        double side = Math.min(0.3 * frame.width / columns, 0.4 * frame.height / rows);
        if (side < 1.5 * frame.width / eye.settings().width()) {
            return;
        }
        int width = (int) (side * columns);
        int height = (int) (side * rows);
        int left = frame.x + frame.width - width - 10;
        int top = frame.y + 10;
        BufferedImage background = shot.background();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int pictureColumn = drone.left() - 2 + column;
                int pictureRow = drone.top() - 2 + row;
                int u = pictureColumn * background.getWidth() / eye.settings().width();
                int v = pictureRow * background.getHeight() / eye.settings().height();
                boolean inside = u >= 0 && v >= 0 && u < background.getWidth() && v < background.getHeight();
                g.setColor(
                        drone.isHit(pictureColumn, pictureRow)
                                ? HIT
                                : inside ? new Color(background.getRGB(u, v)) : BORDER);
                g.fill(new Rectangle2D.Double(left + column * side, top + row * side, side + 0.5, side + 0.5));
            }
        }
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(1.5f));
        g.drawRect(left, top, width, height);
    }
}
