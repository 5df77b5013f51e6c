package org.dronewatch.render.photo;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.Drone;
import org.dronewatch.parallel.Workers;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.World;

/**
 * Takes photographs as a camera would: the colours of the materials, Lambert's cosine law and shadows for the sun,
 * light from the sky, and haze by Koschmieder's law, all according to the world's {@link org.dronewatch.world.Light}.
 * Surfaces are matt; drones cast no shadows. Detection does not depend on these pictures: sensors count the pixels
 * whose centres show the drone.
 *
 * <p>The site without drones is rendered once and kept, so further pictures of a camera that does not move are cheap.
 * The pixels are the same for any number of {@link Workers}. Not thread-safe.
 */
public final class ColourCamera {
    /** The largest number of parts into which a pixel is divided along each axis. */
    public static final int MOST_SAMPLES = 8;

    /** The default number of parts into which a pixel is divided along each axis, sufficient for soft edges. */
    public static final int SAMPLES = 2;

    /** Pixels that are metered along each axis. */
    private static final int METERED = 24;

    /** Lowest metered brightness, because the logarithm of 0 is infinite. */
    private static final double DARKEST = 1e-3;

    private final CameraObject camera;
    private final int samples;
    private final PartGrid grid;
    private final SceneLight light;
    private final Surfaces site;
    private final Map<String, Map<String, Integer>> droneColours;
    private final int tileWidth;
    private final int tileHeight;
    private int[] background;
    private Exposure exposure;

    /**
     * A camera on a stage.
     *
     * @param samples each pixel is the mean of samples x samples rays, 1 to {@value #MOST_SAMPLES}
     * @throws IllegalArgumentException for another number of samples
     */
    public ColourCamera(CameraObject camera, Stage stage, int samples) {
        this(camera, stage.world(), stage.colours(), stage.droneColours(), samples);
    }

    /**
     * A camera in a world.
     *
     * @param colours colours of the world's materials on a screen, by name: red, green and blue in the lowest 24 bits
     * @param droneColours the colours of the drones' materials in the same form, by id of the drone
     * @param samples each pixel is the mean of samples x samples rays, 1 to {@value #MOST_SAMPLES}
     * @throws IllegalArgumentException for another number of samples
     */
    public ColourCamera(
            CameraObject camera,
            World world,
            Map<String, Integer> colours,
            Map<String, Map<String, Integer>> droneColours,
            int samples) {
        if (samples < 1 || samples > MOST_SAMPLES) {
            throw new IllegalArgumentException("samples " + samples + " must be 1 to " + MOST_SAMPLES);
        }
        this.camera = camera;
        this.samples = samples;
        this.grid = new PartGrid(camera, samples);
        this.site = new Surfaces(world, colours);
        this.light = SceneLight.of(world, site);
        this.droneColours = Map.copyOf(droneColours);
        this.tileWidth = TileTracer.WIDTH / samples;
        this.tileHeight = TileTracer.HEIGHT / samples;
    }

    /** Pose and projection. */
    public CameraObject camera() {
        return camera;
    }

    /** A picture with drones. */
    public BufferedImage picture(List<Drone> drones) {
        int across = (camera.width() + tileWidth - 1) / tileWidth;
        int tiles = across * ((camera.height() + tileHeight - 1) / tileHeight);
        if (background == null) {
            int[] pixels = new int[camera.width() * camera.height()];
            exposure = metered();
            Workers.forEach(tiles, this::newTile, (tile, i) -> expose(tile, i, across, List.of(), pixels));
            background = pixels;
        }
        BufferedImage image = new BufferedImage(camera.width(), camera.height(), BufferedImage.TYPE_INT_RGB);
        int[] target = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        System.arraycopy(background, 0, target, 0, target.length);
        List<DroneLayer> layers = drones.stream().map(this::layer).toList();
        Workers.forEach(tiles, this::newTile, (tile, i) -> {
            List<DroneLayer> near = within(layers, i, across);
            if (!near.isEmpty()) {
                expose(tile, i, across, near, target);
            }
        });
        return image;
    }

    /** Meters the site without drones at pixels spread evenly over the picture. */
    private Exposure metered() {
        double[] brightness = new double[METERED * METERED];
        Workers.forEach(METERED, this::newTile, (tile, row) -> {
            for (int column = 0; column < METERED; column++) {
                double[] rgb = tile.radiance(
                        (2 * column + 1) * camera.width() / (2 * METERED),
                        (2 * row + 1) * camera.height() / (2 * METERED),
                        List.of());
                brightness[row * METERED + column] = Math.max(DARKEST, Daylight.brightness(rgb));
            }
        });
        return Exposure.of(brightness, light.light().illuminance());
    }

    /**
     * The mean radiance of a pixel in red, green and blue, relative to that of a white, matt, level surface in all the
     * light.
     */
    double[] radiance(int column, int row, List<Drone> drones) {
        return newTile().radiance(column, row, drones.stream().map(this::layer).toList());
    }

    private PhotoTile newTile() {
        return new PhotoTile(grid, light, site, samples);
    }

    private DroneLayer layer(Drone drone) {
        Map<String, Integer> colours = droneColours.getOrDefault(drone.id(), Map.of());
        return new DroneLayer(drone, new Surfaces(drone.tree().mesh(), colours), camera);
    }

    private List<DroneLayer> within(List<DroneLayer> layers, int tile, int across) {
        return layers.stream()
                .filter(layer ->
                        layer.mayAppear(tile % across * tileWidth, tile / across * tileHeight, tileWidth, tileHeight))
                .toList();
    }

    private void expose(PhotoTile tile, int number, int across, List<DroneLayer> layers, int[] target) {
        int left = number % across * tileWidth;
        int top = number / across * tileHeight;
        tile.expose(
                left,
                top,
                Math.min(tileWidth, camera.width() - left),
                Math.min(tileHeight, camera.height() - top),
                layers,
                exposure,
                target,
                camera.width());
    }
}
