#:property PublishAot=false
// a program of one file, run as "dotnet run eng/compare-searches.cs", is named after what it does
#pragma warning disable MA0048

// Compares two simulated searches of one seed, flown under two runtimes: the same steps and decisions at the same
// times, and targets at the same places to a centimetre. Numbers in the text of a decision may differ by its last
// digit. Usage: dotnet run eng/compare-searches.cs -- A.log A.json B.log B.json
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;

const double MetresPerDegree = 111_320;
const double PlaceTolerance = 0.01;
const double LastDigit = 0.1001;

string[] a = File.ReadAllLines(args[0]);
string[] b = File.ReadAllLines(args[2]);
var faults = new List<string>();
if (a.Length != b.Length)
    faults.Add($"{a.Length} and {b.Length} lines");
for (int i = 0; i < Math.Min(a.Length, b.Length); i++)
{
    if (!AreAlike(a[i], b[i]))
        faults.Add($"line {i + 1}:\n  {a[i]}\n  {b[i]}");
}

double largest = CompareTargets();
foreach (string fault in faults.Take(20))
    Console.WriteLine(fault);
Console.WriteLine(
    string.Create(CultureInfo.InvariantCulture, $"{a.Length} lines, {a.Zip(b).Count(p => p.First != p.Second)} with "
        + $"another last digit; targets differ by at most {largest * 1000:0.000} mm"));
return faults.Count == 0 ? 0 : 1;

// Everything but numbers to the byte, times to the digit, other numbers to their last digit.
static bool AreAlike(string a, string b)
{
    const string Number = @"-?\d+\.\d+";
    if (Regex.Replace(a, Number, "#") != Regex.Replace(b, Number, "#"))
        return false;
    double[] x = Numbers(a);
    double[] y = Numbers(b);
    return x.Length == 0 || x[0].Equals(y[0]) && x.Zip(y).All(p => Math.Abs(p.First - p.Second) <= LastDigit);

    static double[] Numbers(string line)
        => [.. Regex.Matches(line, Number).Select(m => double.Parse(m.Value, CultureInfo.InvariantCulture))];
}

double CompareTargets()
{
    (string Name, double North, double East)[] first = Targets(args[1]);
    (string Name, double North, double East)[] second = Targets(args[3]);
    if (!first.Select(t => t.Name).SequenceEqual(second.Select(t => t.Name), StringComparer.Ordinal))
        faults.Add("other targets");
    double worst = 0;
    foreach (((string name, double north, double east), (_, double otherNorth, double otherEast)) in first.Zip(second))
    {
        double apart = Math.Sqrt(Math.Pow(north - otherNorth, 2) + Math.Pow(east - otherEast, 2));
        worst = Math.Max(worst, apart);
        if (!(apart <= PlaceTolerance))
            faults.Add(string.Create(CultureInfo.InvariantCulture, $"{name}: {apart:0.000} m apart"));
    }

    return worst;
}

// In metres from the equator and the zero meridian: only differences are of interest.
static (string Name, double North, double East)[] Targets(string file)
{
    using JsonDocument document = JsonDocument.Parse(File.ReadAllText(file));
    return [.. document.RootElement.GetProperty("mission").GetProperty("tracks").EnumerateArray().Select(t =>
    {
        double latitude = t.GetProperty("latitudeDegrees").GetDouble();
        double longitude = t.GetProperty("longitudeDegrees").GetDouble();
        return (t.GetProperty("id").ToString() + " " + t.GetProperty("class").GetString(), latitude * MetresPerDegree,
            longitude * MetresPerDegree * Math.Cos(latitude * Math.PI / 180));
    })];
}
