package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.viewer.part.Latest;

/**
 * Renders the site for a window on separate threads: one paints the site itself, coarse at first and fine once nothing
 * moves; the other draws the current sensors and drones over it.
 */
final class SiteRenderer implements AutoCloseable {
    /** Maximum rendering time at full resolution while the view moves, s. */
    private static final double FLUID = 0.05;

    /** A view of the site to be rendered. */
    record Wish(Orbit orbit, int width, int height, Optional<Cut> cut) {}

    private final Latest backdrops;
    private final Latest overlays;
    private final Consumer<BufferedImage> target;

    // Written by the event thread, read by the others.
    private volatile SitePicture picture;
    private volatile SiteState state;
    private volatile SiteStyle style = SiteStyle.DEFAULT;
    private volatile Backdrop backdrop;
    private volatile double plainSeconds;

    /**
     * Starts the threads.
     *
     * @param name with which the names of the threads begin
     * @param target receives each finished image, on any thread
     * @param failed receives what went wrong
     */
    SiteRenderer(String name, int threads, Consumer<BufferedImage> target, Consumer<Throwable> failed) {
        this.target = target;
        this.backdrops = new Latest(name + "-site", threads, failed);
        this.overlays = new Latest(name + "-picture", threads, failed);
    }

    /** Shows another run's site. */
    void show(SitePicture other) {
        picture = other;
        backdrop = null;
    }

    /** Shows the site from another viewpoint; while the view moves, only as finely as keeps the motion smooth. */
    void look(Wish wish, boolean moving) {
        SitePicture painting = picture;
        if (painting != null) {
            backdrops.ask(outdated -> paint(painting, wish, moving, outdated));
        }
    }

    private void paint(SitePicture painting, Wish wish, boolean moving, BooleanSupplier outdated) {
        Backdrop now = backdrop;
        boolean known = now != null
                && now.orbit().equals(wish.orbit())
                && now.width() == wish.width()
                && now.height() == wish.height()
                && now.cut().equals(wish.cut());
        if (!known) {
            // In the middle of a movement a coarse picture in time is better than a fine one too late: it is not
            // abandoned.
            Fineness quick = moving ? fluid() : Fineness.PLAIN;
            long start = System.nanoTime();
            publish(painting, backdrop(painting, wish, quick, () -> false));
            double pixels = (double) wish.width() * wish.height();
            double traced = (double) quick.raysIn(wish.width()) * quick.raysIn(wish.height());
            plainSeconds = pixels / traced * 1e-9 * (System.nanoTime() - start);
        }
        if (!moving && !(known && now.fineness() == Fineness.FINE) && !outdated.getAsBoolean()) {
            Backdrop fine = backdrop(painting, wish, Fineness.FINE, outdated);
            if (!outdated.getAsBoolean()) {
                publish(painting, fine.flat());
            }
        }
    }

    /** The finest level that is fast enough, judging by the last rendering time. */
    private Fineness fluid() {
        if (plainSeconds < FLUID) {
            return Fineness.PLAIN;
        }
        return plainSeconds < 4.0 * FLUID ? Fineness.DRAFT : Fineness.COARSE;
    }

    private static Backdrop backdrop(SitePicture painting, Wish wish, Fineness fineness, BooleanSupplier outdated) {
        return painting.backdrop(wish.orbit(), wish.width(), wish.height(), wish.cut(), fineness, outdated);
    }

    private void publish(SitePicture painting, Backdrop next) {
        if (painting == picture) {
            backdrop = next;
            redraw();
        }
    }

    /** Shows another state of the site. */
    void draw(SiteState next, SiteStyle in) {
        state = next;
        style = in;
        redraw();
    }

    private void redraw() {
        Backdrop behind = backdrop;
        SiteState what = state;
        SitePicture painting = picture;
        if (behind != null && what != null && painting != null) {
            overlays.ask(outdated -> target.accept(painting.draw(behind, what, style)));
        }
    }

    /** The site as it is painted now; empty before it has been painted. */
    Optional<Backdrop> backdrop() {
        return Optional.ofNullable(backdrop);
    }

    /** Whether everything that was requested has been drawn. */
    boolean isIdle() {
        return backdrops.isIdle() && overlays.isIdle();
    }

    @Override
    public void close() {
        backdrops.close();
        overlays.close();
    }
}
