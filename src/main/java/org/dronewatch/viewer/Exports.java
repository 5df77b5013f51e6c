package org.dronewatch.viewer;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import javax.imageio.ImageIO;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.ProgressMonitor;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.dronewatch.parallel.Workers;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.Counted;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.ViewedRun;

/** Exports the display: an image of any part of the window, or the whole run as an image sequence. */
final class Exports {
    private static final String RATE = "10";

    private final ViewerPane pane;
    private final Consumer<Throwable> failed;

    /**
     * Exports of a pane.
     *
     * @param failed receives what went wrong
     */
    Exports(ViewerPane pane, Consumer<Throwable> failed) {
        this.pane = pane;
        this.failed = failed;
    }

    /** Asks for a file, and writes an image of a part of the window to it. */
    void savePicture(Component part, String name) {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter("PNG pictures", "png"));
        chooser.setSelectedFile(new java.io.File(name + ".png"));
        if (chooser.showSaveDialog(pane) == JFileChooser.APPROVE_OPTION) {
            String file = chooser.getSelectedFile().getPath();
            write(part, file.toLowerCase(Locale.ROOT).endsWith(".png") ? file : file + ".png");
        }
    }

    /** Writes an image of a part of the window. */
    void write(Component part, String file) {
        try {
            BufferedImage image = picture(part);
            new WholeFile("picture", file).write(stream -> ImageIO.write(image, "png", stream));
        } catch (RuntimeException e) {
            failed.accept(e);
        }
    }

    /** An image of a part of the window at its screen resolution. */
    static BufferedImage picture(Component part) {
        double density = Scaled.density(part);
        BufferedImage image = new BufferedImage(
                Math.max(1, (int) Math.round(part.getWidth() * density)),
                Math.max(1, (int) Math.round(part.getHeight() * density)),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(density, density);
        part.printAll(g);
        g.dispose();
        return image;
    }

    /**
     * Asks for a directory and a rate, and writes the run as numbered images of the site from the current viewpoint.
     */
    void saveRun() {
        Optional<ViewedRun> viewed = pane.viewed();
        if (viewed.isEmpty()) {
            return;
        }
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle("Directory for the images");
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        if (chooser.showSaveDialog(pane) != JFileChooser.APPROVE_OPTION) {
            return;
        }
        String asked = (String) JOptionPane.showInputDialog(
                pane,
                "Images per simulated second:",
                "Export image sequence",
                JOptionPane.PLAIN_MESSAGE,
                null,
                null,
                RATE);
        if (asked == null) {
            return;
        }
        try {
            double rate = Double.parseDouble(asked.strip());
            if (!(rate > 0.0 && rate <= 1000.0)) {
                throw new NumberFormatException(asked);
            }
            saveRun(viewed.get(), chooser.getSelectedFile().toPath(), rate);
        } catch (NumberFormatException e) {
            pane.notice().show("'" + asked + "' images per second: must be a number above 0, at most 1000");
        }
    }

    private void saveRun(ViewedRun viewed, Path directory, double rate) {
        FrameExport export = export(viewed, directory, rate);
        ProgressMonitor monitor = new ProgressMonitor(pane, "Writing images", " ", 0, export.count());
        monitor.setMillisToPopup(300);
        Thread thread = new Thread(
                () -> {
                    try (Workers workers = new Workers(Runtime.getRuntime().availableProcessors())) {
                        int written = workers.call(() -> export.write(
                                done -> SwingUtilities.invokeLater(() -> monitor.setProgress(done)),
                                monitor::isCanceled));
                        pane.note(Counted.of(written, "image") + " written to " + directory);
                    } catch (RuntimeException e) {
                        failed.accept(e);
                    } finally {
                        SwingUtilities.invokeLater(monitor::close);
                    }
                },
                "dronewatch-export");
        thread.setDaemon(true);
        thread.start();
    }

    /** The export of a run from the pane's current viewpoint. */
    FrameExport export(ViewedRun viewed, Path directory, double rate) {
        return new FrameExport(directory, viewed.run().reached(), rate, pictures(viewed));
    }

    /** Images of a run at any time from the pane's current viewpoint; for use by one thread. */
    DoubleFunction<BufferedImage> pictures(ViewedRun viewed) {
        WorldPanel world = pane.world();
        double density = world.density();
        int width = (int) Math.round(world.getWidth() * density);
        int height = (int) Math.round(world.getHeight() * density);
        SiteStyle style = world.style().withScale(density * Scaled.factor());
        Optional<String> selected = pane.selected();
        Backdrop[] backdrop = new Backdrop[1];
        var orbit = world.orbit();
        var cut = world.cut();
        return time -> {
            if (backdrop[0] == null) {
                backdrop[0] = viewed.picture()
                        .backdrop(orbit, width, height, cut, Fineness.FINE, () -> false)
                        .flat();
            }
            return viewed.picture().draw(backdrop[0], viewed.state(time, selected, Optional.empty()), style);
        };
    }
}
