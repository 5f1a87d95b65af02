using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace Rabit.Geodesy.Tests.Compiler;

/// <summary>What mixes frames, units or heights does not compile; the same line with the right things does.</summary>
public sealed class MixedUnitsTests
{
    [Theory]
    [InlineData("body and NED", "NedVector v = attitude.ToNed(body);", "NedVector v = attitude.ToNed(ned);")]
    [InlineData("places added", "NedPosition p = place + ned;", "NedPosition p = place + place;")]
    [InlineData("a place for a velocity", "NedVector v = place - place;", "NedVector v = place;")]
    [InlineData("a displacement as a place", "var p = frame.ToGeodetic(NedPosition.Origin + ned);",
        "var p = frame.ToGeodetic(ned);")]
    [InlineData("earth-centred places added", "EcefVector v = ecef - ecef;", "var v = ecef + ecef;")]
    [InlineData("a height above the ellipsoid as terrain", "terrain.TryAltitude(point, out AmslAltitude a);",
        "terrain.TryAltitude(point, out EllipsoidHeight a);")]
    [InlineData("NED for body", "BodyVector v = attitude.ToBody(ned);", "BodyVector v = ned;")]
    [InlineData("body in a local frame", "var p = frame.ToGeodetic(place);", "var p = frame.ToGeodetic(body);")]
    [InlineData("a bare number for an angle", "Angle a = Angle.FromDegrees(45.0);", "Angle a = 45.0;")]
    [InlineData("an angle for radians", "double s = Math.Sin(angle.Radians);", "double s = Math.Sin(angle);")]
    [InlineData("degrees as latitude", "var p = new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8));",
        "var p = new GeographicPoint(47, 8);")]
    [InlineData("AMSL for ellipsoid", "EllipsoidHeight h = amsl.ToEllipsoid(47.5);", "EllipsoidHeight h = amsl;")]
    [InlineData("ellipsoid for AMSL", "AmslAltitude h = ellipsoid.ToAmsl(47.5);",
        "AmslAltitude h = (AmslAltitude)ellipsoid;")]
    [InlineData("above home for AMSL", "AmslAltitude h = aboveHome.ToAmsl(amsl);", "AmslAltitude h = aboveHome;")]
    [InlineData("above ground for above home", "HeightAboveGround h = amsl.Above(amsl);",
        "HeightAboveGround h = amsl.AboveHome(amsl);")]
    [InlineData("AMSL in an ellipsoid position", "var p = new EllipsoidPosition(point, ellipsoid);",
        "var p = new EllipsoidPosition(point, amsl);")]
    [InlineData("AMSL position as ellipsoid position", "EcefPosition e = amslPlace.ToEllipsoid(47.5).ToEcef();",
        "EcefPosition e = ((EllipsoidPosition)amslPlace).ToEcef();")]
    [InlineData("different heights compared", "bool b = amsl == amsl;", "bool b = amsl == ellipsoid;")]
    [InlineData("degrees as a position", "var p = GeodeticPosition.FromDegrees(47, 8, 400);",
        "var p = new GeodeticPosition(47, 8, 400);")]
    [InlineData("radians as a position", "var p = GeodeticPosition.FromRadians(0.8, 0.1, 400);",
        "var p = new GeodeticPosition(0.8, 0.1, 400.0);")]
    [InlineData("an angle where degrees are named",
        "var p = GeodeticPosition.FromDegrees(angle.Degrees, angle.Degrees, 400);",
        "var p = GeodeticPosition.FromDegrees(angle, angle, 400);")]
    [InlineData("ellipsoid in an AMSL position", "var p = new GeodeticPosition(point, amsl);",
        "var p = new GeodeticPosition(point, ellipsoid);")]
    [InlineData("above home in an AMSL position", "var p = new GeodeticPosition(point, aboveHome.ToAmsl(amsl));",
        "var p = new GeodeticPosition(point, aboveHome);")]
    [InlineData("bare numbers for an attitude", "var e = EulerAngles.FromDegrees(10, 0, 90);",
        "var e = new EulerAngles(10, 0, 90);")]
    [InlineData("radians for an attitude", "var e = new EulerAngles(angle, angle, Angle.FromRadians(1.5));",
        "var e = new EulerAngles(angle, angle, 1.5);")]
    [InlineData("bare numbers for rates", "var r = BodyRates.FromDegreesPerSecond(10, 0, 0);",
        "var r = new BodyRates(10, 0, 0);")]
    [InlineData("AMSL in a local frame without a geoid", "var f = new LocalNedFrame(amslPlace, 47.5);",
        "var f = new LocalNedFrame(amslPlace);")]
    [InlineData("an ellipsoid height where the geoid is ignored", "var f = LocalNedFrame.IgnoringGeoid(amslPlace);",
        "var f = LocalNedFrame.IgnoringGeoid(amslPlace.ToEllipsoid(0));")]
    [InlineData("ellipsoid place for AMSL from a frame", "EllipsoidPosition p = frame.ToEllipsoid(place);",
        "EllipsoidPosition p = frame.ToGeodetic(place);")]
    [InlineData("rates for a body vector", "NedVector v = attitude.ToNed(body);",
        "NedVector v = attitude.ToNed(BodyRates.FromDegreesPerSecond(1, 2, 3));")]
    [InlineData("UTM for MGRS", "MgrsPosition m = MgrsPosition.From(point);",
        "MgrsPosition m = UtmPosition.From(point);")]
    public void Mixed_DoesNotCompile(string what, string right, string wrong)
    {
        Assert.Empty(Errors(right));
        Assert.True(Errors(wrong).Count > 0, $"{what}: this compiles: {wrong}");
    }

    private static List<string> Errors(string line)
    {
        string program = "using System; using Rabit.Geodesy; static class Program { static void Run(BodyVector body, "
            + "NedVector ned, Rotation attitude, LocalNedFrame frame, "
            + "Angle angle, AmslAltitude amsl, EllipsoidHeight ellipsoid, HeightAboveGround aboveGround, "
            + "HeightAboveHome aboveHome, GeographicPoint point, GeodeticPosition amslPlace, NedPosition place, "
            + "EcefPosition ecef, TerrainGrid terrain) { "
            + line + " } }";
        string[] trusted = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator);
        IEnumerable<MetadataReference> references = trusted
            .Where(f => Path.GetFileName(f).StartsWith("System.", StringComparison.Ordinal))
            .Append(typeof(Angle).Assembly.Location).Select(f => MetadataReference.CreateFromFile(f));
        var compilation = CSharpCompilation.Create(
            "Mixed", [CSharpSyntaxTree.ParseText(program)], references,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
        return [
            .. compilation.GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error).Select(d => d.ToString())
        ];
    }
}
