package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.world.WorldSettings;
import org.jogamp.vecmath.Point2d;

/**
 * The site in 3D. Dragging turns the view; dragging with the right button or Shift moves it; the wheel zooms towards
 * the pointer; a double click centres the view on the point under the pointer; a click on a symbol selects it.
 */
final class WorldPanel extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Time after the last movement from which the site counts as at rest, ms. */
    private static final int REST = 180;

    /** A click within this distance of a symbol hits it, in pixels. */
    private static final double NEAR = 16.0;

    private final transient SiteRenderer renderer;
    private final Timer rest = new Timer(REST, e -> look(false));
    private transient BufferedImage image;
    private transient Orbit orbit;
    private transient WorldSettings site;
    private transient Optional<Cut> cut = Optional.empty();
    private transient SiteState recorded;
    private transient SiteState state;
    private transient SiteStyle style = SiteStyle.DEFAULT;
    private transient Consumer<String> selection = id -> {};
    private transient Consumer<String> hint = text -> {};
    private transient Consumer<Optional<Position>> pointed = place -> {};
    private transient WorldGrip grip = WorldGrip.NONE;
    private transient WorldTool tool = WorldTool.NONE;
    private transient UnaryOperator<SiteState> overlay = UnaryOperator.identity();
    private transient Runnable viewChanged = () -> {};

    /**
     * An empty view.
     *
     * @param name with which the names of its threads begin
     * @param threads number of threads that paint the site
     * @param failed receives what went wrong
     */
    WorldPanel(String name, int threads, Consumer<Throwable> failed) {
        this.renderer = new SiteRenderer(
                name,
                threads,
                picture -> SwingUtilities.invokeLater(() -> {
                    image = picture;
                    repaint();
                }),
                failed);
        rest.setRepeats(false);
        setPreferredSize(Scaled.size(760, 560));
        setMinimumSize(Scaled.size(200, 150));
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
        getAccessibleContext().setAccessibleName("site");
        WorldMouse mouse = new WorldMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                move(orbit);
            }
        });
    }

    /** Sets what receives the sensor or drone that was clicked on. */
    void onSelection(Consumer<String> target) {
        selection = target;
    }

    /** Sets what receives a description of the object under the pointer. */
    void onHint(Consumer<String> target) {
        hint = target;
    }

    /** Sets what receives the point of the site under the pointer; empty for the sky. */
    void onPointed(Consumer<Optional<Position>> target) {
        pointed = target;
    }

    /** Sets what is run whenever the viewpoint, the cut or the style has been set. */
    void onViewChanged(Runnable target) {
        viewChanged = target;
    }

    /** Sets what the mouse moves in place of the view. */
    void setGrip(WorldGrip other) {
        grip = other;
    }

    /** Sets the tool that receives clicks while it is on. */
    void setTool(WorldTool other) {
        tool = other;
    }

    WorldTool tool() {
        return tool;
    }

    WorldGrip grip() {
        return grip;
    }

    /** Shows another run's site. */
    void show(SitePicture picture, Orbit from, Optional<Cut> without) {
        renderer.show(picture);
        site = picture.site();
        move(from, without);
        look(false);
    }

    /** Sets what changes each state before it is drawn, for instance by moving sensors. */
    void setOverlay(UnaryOperator<SiteState> other) {
        overlay = other;
    }

    /** Shows another state. */
    void show(SiteState next) {
        recorded = next;
        redraw();
    }

    /** Draws the state anew, because the overlay now changes it in another way. */
    void redraw() {
        if (recorded != null) {
            state = overlay.apply(recorded);
            renderer.draw(state, style.withScale(density() * Scaled.factor()));
        }
    }

    SiteStyle style() {
        return style;
    }

    void setStyle(SiteStyle other) {
        style = other;
        redraw();
        viewChanged.run();
    }

    Orbit orbit() {
        return orbit;
    }

    Optional<Cut> cut() {
        return cut;
    }

    void setCut(Optional<Cut> other) {
        move(orbit, other);
    }

    /** Shows the site from another viewpoint: coarsely at once, finely when nothing has moved for a moment. */
    void move(Orbit to) {
        move(to, cut);
    }

    /** Shows the site from another viewpoint, with another cut. */
    void move(Orbit to, Optional<Cut> without) {
        orbit = to;
        cut = without;
        look(true);
        rest.restart();
        viewChanged.run();
    }

    private void look(boolean moving) {
        int width = (int) Math.round(getWidth() * density());
        int height = (int) Math.round(getHeight() * density());
        if (orbit != null && width > 0 && height > 0) {
            renderer.look(new SiteRenderer.Wish(orbit, width, height, cut), moving);
        }
    }

    /** The number of screen pixels per Swing pixel. */
    double density() {
        return Scaled.density(this);
    }

    /** The ratio of width to height. */
    double aspect() {
        return getHeight() == 0 ? 1.5 : getWidth() / (double) getHeight();
    }

    /** Selects the object at a pixel of this panel. */
    void select(int x, int y) {
        if (state == null || orbit == null) {
            return;
        }
        if (tool.isOn()) {
            tool.click(x, y);
            return;
        }
        SymbolPick pick = pick(x, y);
        selection.accept(pick.chosen().orElse(null));
        pick.hint().ifPresent(hint);
    }

    private SymbolPick pick(int x, int y) {
        return SymbolPick.of(state, place -> distance(place, x, y), NEAR * Scaled.factor());
    }

    /** The sensor or drone whose symbol is at a pixel of this panel. */
    Optional<String> symbolAt(int x, int y) {
        return state == null ? Optional.empty() : pick(x, y).chosen();
    }

    /** The place from which the site is seen, m; there must be a site. */
    Position eye() {
        return orbit.camera(getWidth(), getHeight()).position();
    }

    private double distance(Position place, int x, int y) {
        return pixelOf(place).map(at -> at.distance(new Point2d(x, y))).orElse(Double.POSITIVE_INFINITY);
    }

    /** Whether the symbol of something at a place, m, is at a pixel of this panel. */
    boolean isSymbolAt(Position place, int x, int y) {
        return distance(place, x, y) < NEAR * Scaled.factor();
    }

    /** The pixel of this panel at which a place, m, is drawn; empty where it is out of the picture. */
    Optional<Point2d> pixelOf(Position place) {
        return orbit == null
                ? Optional.empty()
                : orbit.camera(getWidth(), getHeight()).pixelOf(place.toPoint3d());
    }

    /** The point of the world at a pixel of this panel. */
    Optional<Position> placeAt(int x, int y) {
        double density = density();
        return renderer.backdrop()
                .flatMap((Backdrop behind) -> behind.placeAt((int) (x * density), (int) (y * density)));
    }

    /** Describes the object under the pointer. */
    void describe(int x, int y) {
        Optional<Position> place = placeAt(x, y);
        setCursor(Cursor.getPredefinedCursor(grip.isAt(x, y) ? Cursor.MOVE_CURSOR : Cursor.CROSSHAIR_CURSOR));
        pointed.accept(place);
        hint.accept(tool.hint(x, y)
                .or(() -> place.map(point -> site == null ? Texts.place(point) : Texts.place(point, site)))
                .orElse("sky"));
    }

    /** The displayed image, or null before the first. */
    BufferedImage image() {
        return image;
    }

    /** Whether everything that was requested is drawn; from any thread. */
    boolean isIdle() {
        return !rest.isRunning() && renderer.isIdle();
    }

    @Override
    protected void paintComponent(Graphics g) {
        if (image == null) {
            g.setColor(new Color(0xdbe1e6));
            g.fillRect(0, 0, getWidth(), getHeight());
        } else {
            g.drawImage(image, 0, 0, getWidth(), getHeight(), null);
            Graphics2D over = (Graphics2D) g.create();
            tool.paint(over);
            over.dispose();
        }
    }

    /** Ends the threads that paint. */
    void close() {
        rest.stop();
        renderer.close();
    }
}
