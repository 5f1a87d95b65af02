using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads and writes what camera.json says of the camera itself: size, focal length, lens, readout.</summary>
internal static class CameraModelDescription
{
    private const string Distortion = "distortion";
    private const string Lens = "lens";
    private const string Pixels = "pixels";
    private const string ColourPixels = "rgb24";
    private const string ThermalPixels = "grey16";
    private const string BrownConrady = "brownConrady";
    private const string Fisheye = "fisheye";
    private const string Readout = "readoutMicroseconds";
    private const string RowReadout = "rowReadoutMicroseconds";
    private const string FieldOfView = "horizontalFieldOfViewDegrees";
    private const string Millimetres = "focalLengthMillimetres";
    private const string SensorWidth = "sensorWidthMillimetres";
    private const string Equivalent = "focalLength35MillimetreEquivalentMillimetres";
    private const string Error = "focalLengthError";

    // A data sheet rounds them; of a calibrated camera nothing is known to be wrong.
    private const double ErrorOfDataSheet = 0.01;
    private const double TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000.0;

    /// <param name="camera">The object of the camera.</param>
    /// <param name="faults">
    /// Those that <paramref name="camera"/> adds to; where there are any, what is returned is of no use.
    /// </param>
    public static CameraModel Read(JsonFields camera, List<string> faults)
    {
        camera.Has("name");
        camera.Renamed(("dist_k1_k2_p1_p2_k3", Distortion), ("row_readout_us", RowReadout));
        int width = camera.RequiredWholeNumber("width");
        int height = camera.RequiredWholeNumber("height");
        bool isFisheye = camera.Choice(Lens, BrownConrady, Fisheye) == Fisheye;
        FocalPixels focal = ReadFocalLength(camera, width, height, isFisheye, faults);
        double[] k = ReadDistortion(camera, isFisheye, isOptional: !focal.IsCalibrated);
        return new CameraModel
        {
            Width = width,
            Height = height,
            Format = camera.Choice(Pixels, ColourPixels, ThermalPixels) == ThermalPixels
                ? PixelFormat.Grey16
                : PixelFormat.Rgb24,
            FocalX = focal.X,
            FocalY = focal.Y,
            CentreX = focal.IsCalibrated ? camera.RequiredNumber("cx") : camera.Number("cx") ?? ((width - 1) / 2.0),
            CentreY = focal.IsCalibrated ? camera.RequiredNumber("cy") : camera.Number("cy") ?? ((height - 1) / 2.0),
            FocalLengthError = camera.Number(Error) ?? focal.Error,
            Lens = isFisheye ? LensModel.Fisheye : LensModel.BrownConrady,
            K1 = k[0],
            K2 = k[1],
            P1 = isFisheye ? 0 : k[2],
            P2 = isFisheye ? 0 : k[3],
            K3 = isFisheye ? k[2] : k[4],
            K4 = isFisheye ? k[3] : k[5],
            K5 = k[6],
            K6 = k[7],
            Readout = ReadReadout(camera, height, faults),
        };
    }

    public static void Write(Utf8JsonWriter json, CameraModel camera)
    {
        json.WriteNumber("width", camera.Width);
        json.WriteNumber("height", camera.Height);
        if (camera.Format == PixelFormat.Grey16)
            json.WriteString(Pixels, ThermalPixels);
        json.WriteNumber("fx", camera.FocalX);
        json.WriteNumber("fy", camera.FocalY);
        json.WriteNumber("cx", camera.CentreX);
        json.WriteNumber("cy", camera.CentreY);
        if (camera.FocalLengthError > 0)
            json.WriteNumber(Error, camera.FocalLengthError);
        if (camera.Lens == LensModel.Fisheye)
            json.WriteString(Lens, Fisheye);
        CameraDescription.WriteNumbers(json, Distortion, Coefficients(camera));
        if (camera.Readout > TimeSpan.Zero)
            json.WriteNumber(Readout, camera.Readout.Ticks / TicksPerMicrosecond);
    }

    private static double[] Coefficients(CameraModel camera)
    {
        if (camera.Lens == LensModel.Fisheye)
            return [camera.K1, camera.K2, camera.K3, camera.K4];
        return camera.K4 == 0 && camera.K5 == 0 && camera.K6 == 0
            ? [camera.K1, camera.K2, camera.P1, camera.P2, camera.K3]
            : [camera.K1, camera.K2, camera.P1, camera.P2, camera.K3, camera.K4, camera.K5, camera.K6];
    }

    // In the order of OpenCV; eight numbers, of which those that are not there are 0.
    private static double[] ReadDistortion(JsonFields camera, bool isFisheye, bool isOptional)
    {
        if (isOptional && !camera.Has(Distortion))
            return new double[8];
        double[] read = isFisheye
            ? camera.RequiredNumbers(Distortion, 4)
            : camera.RequiredNumbers(Distortion, 5, 8);
        return [.. read, .. new double[8 - read.Length]];
    }

    private static TimeSpan ReadReadout(JsonFields camera, int height, List<string> faults)
    {
        if (camera.Has(Readout) && camera.Has(RowReadout))
            faults.Add($"camera has both {Readout}, of the whole picture, and {RowReadout}; it must have one of them");
        double microseconds = camera.Number(Readout) ?? (camera.Number(RowReadout) * height) ?? 0;
        double ticks = Math.Round(microseconds * TicksPerMicrosecond);

        // What no picture takes is refused by the camera; it only has to stay a time.
        return Math.Abs(ticks) < TimeSpan.TicksPerDay ? TimeSpan.FromTicks((long)ticks) : TimeSpan.FromDays(1);
    }

    private static FocalPixels ReadFocalLength(
        JsonFields camera, int width, int height, bool isFisheye, List<string> faults)
    {
        // Each is asked for, so that none is unknown beside the others.
        bool isByPixels = camera.Has("fx") | camera.Has("fy");
        bool isByAngle = camera.Has(FieldOfView);
        bool isBySensor = camera.Has(Millimetres) | camera.Has(SensorWidth);
        bool isByFilm = camera.Has(Equivalent);
        int ways = new[] { isByPixels, isByAngle, isBySensor, isByFilm }.Count(w => w);
        if (ways > 1)
        {
            faults.Add($"camera says its focal length in {ways} ways; it must be one of fx and fy, {FieldOfView}, "
                + $"{Millimetres} and {SensorWidth}, or {Equivalent}");
        }

        if (isFisheye && ways > 0 && !isByPixels)
            faults.Add("camera is a fisheye, whose focal length must be given by fx and fy");
        if (isByAngle)
        {
            double degrees = camera.RequiredNumber(FieldOfView);
            if (degrees is <= 0 or >= 180)
                faults.Add(FormattableString.Invariant(
                    $"camera.{FieldOfView} is {degrees}; it must be above 0 and below 180"));
            return new FocalPixels(
                FocalLength.FromFieldOfView(width, Angle.FromDegrees(degrees)), ErrorOfDataSheet);
        }

        if (isBySensor)
        {
            double sensor = camera.RequiredNumber(SensorWidth);
            if (sensor <= 0)
                faults.Add(FormattableString.Invariant($"camera.{SensorWidth} is {sensor}; it must be above 0"));
            return new FocalPixels(
                FocalLength.FromSensor(width, camera.RequiredNumber(Millimetres), sensor), ErrorOfDataSheet);
        }

        if (isByFilm)
        {
            double equivalent = camera.RequiredNumber(Equivalent);
            if (equivalent <= 0)
                faults.Add(FormattableString.Invariant($"camera.{Equivalent} is {equivalent}; it must be above 0"));
            return new FocalPixels(
                FocalLength.From35MillimetreEquivalent(Math.Max(width, height), equivalent),
                FocalLength.ErrorOf35MillimetreEquivalent(equivalent));
        }

        return new FocalPixels(camera.RequiredNumber("fx"), camera.RequiredNumber("fy"), 0, true);
    }

    private readonly record struct FocalPixels(double X, double Y, double Error, bool IsCalibrated)
    {
        public FocalPixels(double pixels, double error)
            : this(pixels, pixels, error, IsCalibrated: false)
        {
        }
    }
}
