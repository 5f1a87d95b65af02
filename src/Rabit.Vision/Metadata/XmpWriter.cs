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
        Add(text, "AbsoluteAltitude", photo.AbsoluteAltitudeMetres, XmpReader.MaxMetres);
        Add(text, "RelativeAltitude", photo.RelativeAltitudeMetres, XmpReader.MaxMetres);
        Add(text, "GimbalRollDegree", photo.GimbalRollDegrees, XmpReader.MaxDegrees);
        Add(text, "GimbalPitchDegree", photo.GimbalPitchDegrees, XmpReader.MaxDegrees);
        Add(text, "GimbalYawDegree", photo.GimbalYawDegrees, XmpReader.MaxDegrees);
        Add(text, "FlightRollDegree", photo.FlightRollDegrees, XmpReader.MaxDegrees);
        Add(text, "FlightPitchDegree", photo.FlightPitchDegrees, XmpReader.MaxDegrees);
        Add(text, "FlightYawDegree", photo.FlightYawDegrees, XmpReader.MaxDegrees);
        Add(text, "CalibratedFocalLength", photo.FocalLengthPixels, XmpReader.MaxPixels);
        if (photo.Lens is { } lens && XmpLens.Write(lens, photo.TakenLocal) is var known
            && XmpLens.Read(known) is not null)
        {
            text.Append("\n   drone-dji:DewarpData=\"").Append(known)
                .Append("\"\n   drone-dji:DewarpFlag=\"0\"");
        }

        text.Append("/>\n </rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>");
        return text.ToString();
    }

    // What is no number, or out of its range, is left out.
    private static void Add(StringBuilder text, string name, double? value, double max)
    {
        if (value is { } number && number >= -max && number <= max)
            text.Append("\n   drone-dji:").Append(name).Append("=\"")
                .Append(number.ToString("+0.00000;-0.00000", CultureInfo.InvariantCulture)).Append('"');
    }
}
