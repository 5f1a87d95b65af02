using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Recordings;

/// <summary>
/// The simulated Copter against recordings of the real one: what was done to it is done again at the same times. Modes,
/// MAV_STATE, landed states, answers and texts are the same; times of what follows by itself differ by at most a fifth.
/// What the model leaves out stands in docs/concepts/simulation.md.
/// </summary>
public class CopterRecordingTests(ITestOutputHelper output)
{
    // HEARTBEAT and EXTENDED_SYS_STATE came at 5 Hz, from both.
    private const double ReportSeconds = 0.25;
    private const double AllowedPart = 0.2;

    // Texts that the model has: of failsafes, takeovers, rejections, arming.
    private static readonly Regex Compared = new(
        "^(Battery|Radio Failsafe|GCS Failsafe|EKF (Failsafe|variance)|GPS Glitch|Mode change|Arm: (?!Accels|Gyros|EKF"
            + "|AHRS|Need Alt)|(Arming|Disarming) motors|Manual recovery|.* fence breached|Fence )",
        RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1));

    private static readonly Regex UsedCharge = new(" used \\d+ mAh", RegexOptions.None, TimeSpan.FromSeconds(1));

    [Theory]
    [InlineData("ap-takeover")]
    [InlineData("ap-mode-race")]
    [InlineData("ap-guided-other-commander")]
    [InlineData("ap-battery-warn")]
    [InlineData("ap-battery-rtl")]
    [InlineData("ap-gcs-failsafe")]
    [InlineData("ap-rc-failsafe")]
    [InlineData("ap-gps-ekf-failsafe")]
    [InlineData("ap-fence-reboot")]
    [InlineData("ap-wind", 0, -1, 100)]     // then the real one does not notice in the wind that it has landed
    [InlineData("ap-guided", 39.6, 19)]    // before, the real one has other reasons not to arm: its sensors warm up
    public void Actions_DoneAgain_LeadToTheSame(
        string name, double positionAfter = 0, double from = -1, double to = double.MaxValue)
    {
        Recording recording = Recording.Read(name);
        using CopterReplay replay = CopterReplay.Fly(recording, positionAfter);

        var faults = new List<string>();
        Compare("modes", recording, Between(recording.ModeReports), Between(replay.ModeReports), faults);
        Compare("landed states", recording, Between(recording.LandedStates), Between(replay.LandedStates), faults);
        CompareTexts("answers", recording.Acknowledgements.ToArray(), replay.Acknowledgements.ToArray(), faults);
        CompareTexts("texts", Comparable(Between(recording.Texts)), Comparable(Between(replay.Texts)), faults);
        Assert.True(faults.Count == 0, name + ":\n" + string.Join("\n", faults));

        List<(double Time, string State)> Between(IEnumerable<(double Time, string State)> all)
            => all.Where(r => r.Time >= from && r.Time < to).ToList();
    }

    private void Compare(
        string what, Recording recording, List<(double Time, string State)> real,
        List<(double Time, string State)> simulated, List<string> faults)
    {
        for (int index = 0; index < Math.Max(real.Count, simulated.Count); index++)
        {
            output.WriteLine($"{what}: real {Text(real, index)}, simulated {Text(simulated, index)}");
            if (index >= real.Count || index >= simulated.Count || real[index].State != simulated[index].State)
            {
                faults.Add($"{what}: real {Text(real, index)}, simulated {Text(simulated, index)}");
                return;
            }

            double since = real[index].Time - recording.LastCauseBefore(real[index].Time);
            if (index > 0 && Math.Abs(real[index].Time - simulated[index].Time) > ReportSeconds + (AllowedPart * since))
                faults.Add($"{what}: real {Text(real, index)}, simulated {Text(simulated, index)}, "
                    + $"{since:0.00} s after its cause");
        }
    }

    private static void CompareTexts(string what, string[] real, string[] simulated, List<string> faults)
    {
        if (!real.SequenceEqual(simulated))
            faults.Add($"{what}:\n  real {string.Join(" | ", real)}\n  simulated {string.Join(" | ", simulated)}");
    }

    // The charge that was used is another one: another vehicle. And a glitch that has lasted for long does not end for
    // the real one, whose estimate has followed it, so that the loss of the GPS is not a second one.
    private static string[] Comparable(IEnumerable<(double Time, string Text)> texts)
    {
        var compared = new List<string>();
        foreach (string text in texts.Select(t => t.Text).Where(t => Compared.IsMatch(t)))
        {
            if (!text.StartsWith("GPS Glitch", StringComparison.Ordinal) || !compared.Contains(text))
                compared.Add(UsedCharge.Replace(text, string.Empty));
        }

        return compared.ToArray();
    }

    private static string Text(List<(double Time, string State)> reports, int index)
        => index < reports.Count ? $"{reports[index].State} at {reports[index].Time:0.00}" : "nothing";
}
