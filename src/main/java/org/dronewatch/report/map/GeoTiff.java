package org.dronewatch.report.map;

import java.awt.Color;
import java.awt.Point;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferFloat;
import java.awt.image.DataBufferUShort;
import java.awt.image.IndexColorModel;
import java.awt.image.PixelInterleavedSampleModel;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.plugins.tiff.GeoTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import javax.imageio.plugins.tiff.TIFFTag;
import javax.imageio.stream.FileImageOutputStream;
import javax.imageio.stream.ImageOutputStream;
import org.dronewatch.geo.Origin;

/**
 * Writes square grids of classes (with a palette), of numbers, or of counts as GeoTIFF 1.1 (OGC 19-008r4), with one
 * band, compressed by deflate. TIFF cannot name classes, so their names go into a file beside the image, where GDAL and
 * QGIS find them. Equal grids give the same bytes.
 */
public final class GeoTiff {
    /** The number that marks cells without a class. */
    public static final int NO_CLASS = 255;

    /** The number that marks cells without a value; not a NaN, which some programs do not recognise. */
    public static final float NO_NUMBER = -9999f;

    private static final int CLASSES = 256;
    private static final int NO_COUNT = 65_535;

    /** A tag that is not in the JDK's sets: GDAL's text for the value that represents the absence of one. */
    private static final int NODATA = 42113;

    private static final int PROJECTED = 1;
    private static final int PIXEL_IS_AREA = 1;
    private static final int METRE = 9001;

    private final GridGeoreference place;
    private final int columns;

    /**
     * A kind of cell.
     *
     * @param name its name
     * @param colour its colour
     */
    public record CellClass(String name, Color colour) {}

    /**
     * A writer of grids.
     *
     * @param origin geographic position of the origin of the scene
     * @param east east coordinate of the grid's centre, m
     * @param north north coordinate of its centre, m
     * @param cell length of a cell's side, m
     * @param columns cells along a side
     * @throws org.dronewatch.setting.InputException if the grid has no coordinates in the UTM zone or the polar grid of
     *     the origin
     */
    public GeoTiff(Origin origin, double east, double north, double cell, int columns) {
        this.place = GridGeoreference.of(origin, east, north, cell, columns);
        this.columns = columns;
    }

    /**
     * Writes classes, and their names to a second file beside the first.
     *
     * @param cells the class number of each cell, row by row from the north-west; {@link #NO_CLASS} for none
     * @param classes the classes in the order of their numbers, from 0
     */
    public void writeClasses(Path file, byte[] cells, List<CellClass> classes) throws IOException {
        byte[][] palette = new byte[3][CLASSES];
        for (int i = 0; i < classes.size(); i++) {
            Color colour = classes.get(i).colour();
            palette[0][i] = (byte) colour.getRed();
            palette[1][i] = (byte) colour.getGreen();
            palette[2][i] = (byte) colour.getBlue();
        }
        IndexColorModel model = new IndexColorModel(8, CLASSES, palette[0], palette[1], palette[2]);
        BufferedImage image = new BufferedImage(columns, columns, BufferedImage.TYPE_BYTE_INDEXED, model);
        image.getRaster().setDataElements(0, 0, columns, columns, cells);
        write(file, image, String.valueOf(NO_CLASS));
        writeNames(file.resolveSibling(file.getFileName() + ".aux.xml"), classes);
    }

    /**
     * Writes single-precision numbers.
     *
     * @param cells the values of the cells, row by row from the north-west; NaN for none
     */
    public void writeNumbers(Path file, float[] cells) throws IOException {
        float[] values = cells.clone();
        for (int i = 0; i < values.length; i++) {
            values[i] = Float.isNaN(values[i]) ? NO_NUMBER : values[i];
        }
        write(
                file,
                grey(new DataBufferFloat(values, values.length), DataBuffer.TYPE_FLOAT),
                String.format(Locale.ROOT, "%.0f", NO_NUMBER));
    }

    /**
     * Writes counts.
     *
     * @param cells the counts of the cells, row by row from the north-west, 0 to 65,534; below 0 for none
     */
    public void writeCounts(Path file, int[] cells) throws IOException {
        short[] values = new short[cells.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) (cells[i] < 0 ? NO_COUNT : Math.min(cells[i], NO_COUNT - 1));
        }
        write(
                file,
                grey(new DataBufferUShort(values, values.length), DataBuffer.TYPE_USHORT),
                String.valueOf(NO_COUNT));
    }

    private RenderedImage grey(DataBuffer data, int type) {
        PixelInterleavedSampleModel samples =
                new PixelInterleavedSampleModel(type, columns, columns, 1, columns, new int[] {0});
        ColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), false, false, ColorModel.OPAQUE, type);
        return new BufferedImage(model, Raster.createWritableRaster(samples, data, new Point()), false, null);
    }

    private void write(Path file, RenderedImage image, String nodata) throws IOException {
        ImageWriter writer = jdkWriter();
        try (ImageOutputStream stream = new FileImageOutputStream(file.toFile())) {
            ImageWriteParam parameters = writer.getDefaultWriteParam();
            parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            parameters.setCompressionType("ZLib");
            IIOMetadata blank =
                    writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), parameters);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, georeferenced(blank, nodata)), parameters);
        } finally {
            writer.dispose();
        }
    }

    /** The JDK's own writer; others on the class path may use other metadata. */
    private static ImageWriter jdkWriter() {
        for (Iterator<ImageWriter> all = ImageIO.getImageWritersByFormatName("tiff"); all.hasNext(); ) {
            ImageWriter writer = all.next();
            if (writer.getClass().getModule() == ImageIO.class.getModule()) {
                return writer;
            }
        }
        throw new IllegalStateException("this Java platform has no writer for TIFF");
    }

    private IIOMetadata georeferenced(IIOMetadata blank, String nodata) throws IOException {
        TIFFDirectory tags = TIFFDirectory.createFromMetadata(blank);
        GeoTIFFTagSet geo = GeoTIFFTagSet.getInstance();
        double[] m = place.matrix();
        double[] transform = {m[0], m[1], 0, m[2], m[3], m[4], 0, m[5], 0, 0, 0, 0, 0, 0, 0, 1};
        tags.addTIFFField(
                new TIFFField(geo.getTag(GeoTIFFTagSet.TAG_MODEL_TRANSFORMATION), TIFFTag.TIFF_DOUBLE, 16, transform));
        char[] keys = {
            // Version 1.1 of the keys, four of them: each with its number, the location of its value, the number of
            // values, and the value.
            1, 1, 1, 4,
            1024, 0, 1, PROJECTED,
            1025, 0, 1, PIXEL_IS_AREA,
            3072, 0, 1, (char) place.code(),
            3076, 0, 1, METRE
        };
        tags.addTIFFField(
                new TIFFField(geo.getTag(GeoTIFFTagSet.TAG_GEO_KEY_DIRECTORY), TIFFTag.TIFF_SHORT, keys.length, keys));
        TIFFTag none = new TIFFTag("GDAL_NODATA", NODATA, 1 << TIFFTag.TIFF_ASCII);
        tags.addTIFFField(new TIFFField(none, TIFFTag.TIFF_ASCII, 1, new String[] {nodata}));
        return tags.getAsMetadata();
    }

    /** GDAL's persistent auxiliary metadata. */
    private static void writeNames(Path file, List<CellClass> classes) throws IOException {
        StringBuilder text = new StringBuilder("<PAMDataset>\n  <PAMRasterBand band=\"1\">\n    <CategoryNames>\n");
        for (CellClass one : classes) {
            text.append("      <Category>").append(one.name()).append("</Category>\n");
        }
        text.append("    </CategoryNames>\n  </PAMRasterBand>\n</PAMDataset>\n");
        Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }
}
