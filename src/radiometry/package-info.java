/**
 * The quantities of light in three channels: red, green and blue of <em>linear</em> sRGB, everywhere. What is shown on a
 * screen is encoded at the very end, and colours given as sRGB are decoded at the very beginning.
 *
 * <table>
 * <caption>Quantities and units</caption>
 * <tr><th>quantity</th><th>symbol</th><th>unit</th><th>class</th></tr>
 * <tr><td>power</td><td>Φ</td><td>W</td><td>{@link radiometry.RadianceRGB}</td></tr>
 * <tr><td>intensity</td><td>I</td><td>W/sr</td><td>{@link radiometry.RadianceRGB}</td></tr>
 * <tr><td>irradiance</td><td>E</td><td>W per square scene unit</td><td>{@link radiometry.RadianceRGB}</td></tr>
 * <tr><td>radiance</td><td>L</td><td>W/sr per square scene unit</td><td>{@link radiometry.RadianceRGB}</td></tr>
 * <tr><td>reflectance</td><td>k</td><td>1, from 0 to 1</td><td>{@link radiometry.ReflectanceRGB}</td></tr>
 * <tr><td>share of the power in a channel</td><td></td><td>1, sum 1</td><td>{@link radiometry.SpectrumRGB}</td></tr>
 * </table>
 *
 * <p>A power Φ has in channel c the part 3 · share<sub>c</sub> · Φ, so that equal shares are white light of Φ in each
 * channel.
 */
package radiometry;
