using System.Globalization;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// Writes the properties of a drone as XMP (ISO 16684-1), in the namespace of DJI, which programs of photogrammetry
/// read.
/// </summary>
internal static class XmpWriter
{
    private const int MaxLength = 1000;

    public static string Write(PhotoMetadata photo)
    {
        var text = new StringBuilder(MaxLength);
        text.Append("<?xpacket begin=\"\uFEFF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n")
            .Append("<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n")
            .Append(" <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n")
            .Append("  <rdf:Description rdf:about=\"\" xmlns:drone-dji=\"http://www.dji.com/drone-dji/1.0/\"");
        Add(text, "AbsoluteAltitude", photo.AbsoluteAltitudeMetres);
        Add(text, "RelativeAltitude", photo.RelativeAltitudeMetres);
        Add(text, "GimbalRollDegree", photo.GimbalRollDegrees);
        Add(text, "GimbalPitchDegree", photo.GimbalPitchDegrees);
        Add(text, "GimbalYawDegree", photo.GimbalYawDegrees);
        Add(text, "FlightRollDegree", photo.FlightRollDegrees);
        Add(text, "FlightPitchDegree", photo.FlightPitchDegrees);
        Add(text, "FlightYawDegree", photo.FlightYawDegrees);
        Add(text, "CalibratedFocalLength", photo.FocalLengthPixels);
        if (photo.Lens is { } lens)
        {
            text.Append("\n   drone-dji:DewarpData=\"").Append(XmpLens.Write(lens, photo.TakenLocal))
                .Append("\"\n   drone-dji:DewarpFlag=\"0\"");
        }

        text.Append("/>\n </rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>");
        return text.ToString();
    }

    private static void Add(StringBuilder text, string name, double? value)
    {
        if (value is { } number)
            text.Append("\n   drone-dji:").Append(name).Append("=\"")
                .Append(number.ToString("+0.00000;-0.00000", CultureInfo.InvariantCulture)).Append('"');
    }
}
