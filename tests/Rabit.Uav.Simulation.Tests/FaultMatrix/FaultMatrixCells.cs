using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using static Rabit.Uav.Simulation.Tests.FaultMatrix.MatrixFaults;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>The fault matrix: how each flight has to end, written before it is flown, with the reason.</summary>
/// <remarks>
/// One letter for each phase of <see cref="Phases"/>; see <see cref="Letters"/>. A dot: there is no such cell.
/// </remarks>
internal static class FaultMatrixCells
{
    private const SimulatedAutopilot Ardu = SimulatedAutopilot.ArduPilot;
    private const SimulatedAutopilot Px4 = SimulatedAutopilot.Px4;

    // Seeds whose flights have all the phases.
    public static readonly long[] Seeds = [5, 6, 8];

    public static readonly MissionPhase[] Phases =
    [
        MissionPhase.TakingOff, MissionPhase.InTransit, MissionPhase.Searching, MissionPhase.Revisiting,
        MissionPhase.Holding, MissionPhase.Returning, MissionPhase.Landing,
    ];

    public static readonly IReadOnlyDictionary<char, MatrixEnd> Letters = new Dictionary<char, MatrixEnd>
    {
        ['A'] = MatrixEnd.Accomplished,
        ['R'] = MatrixEnd.ReturnsAndLands,
        ['L'] = MatrixEnd.LandsWhereItIs,
        ['W'] = MatrixEnd.HoldsThenReturns,
        ['P'] = MatrixEnd.PilotHasIt,
        ['F'] = MatrixEnd.FailsafeHasIt,
        ['O'] = MatrixEnd.OtherCommanderHasIt,
        ['B'] = MatrixEnd.Rebooted,
        ['X'] = MatrixEnd.Falls,
        ['D'] = MatrixEnd.LandedWithoutUs,
        ['H'] = MatrixEnd.HoldsAtStop,
        ['K'] = MatrixEnd.StopsInItsReturn,
    };

    private static readonly (MatrixFault Fault, SimulatedAutopilot? Model, string Ends, string Reason)[] Rows =
    [
        (PilotHold, Ardu, "PPPPPPP", "the pilot's mode stands"),
        (PilotHold, Px4, "PPPPAPP", "the pilot's mode stands; while we hold it is no other mode"),
        (PilotPosition, null, "PPPPPPP", "the pilot's mode stands"),
        (PilotReturn, null, "PPPPPAA", "the pilot's return stands; in our own return nothing changes"),
        (PilotLand, Ardu, "PPPPPLA", "the pilot's landing stands; our own return ends in the same mode by itself"),
        (PilotLand, Px4, "PPPPPPP", "the pilot's landing stands; PX4 lands in AUTO.RTL"),
        (OtherReposition, Ardu, "OOOOOPP", "a target in GUIDED changes no mode; in the return it takes GUIDED"),
        (OtherReposition, Px4, "PPPPOPP", "it takes AUTO.LOITER, which is another mode except in our hold"),
        (OtherTargets, Ardu, "OOOOOAA", "a target in GUIDED changes no mode; in the return it is ignored"),
        (OtherTargets, Px4, "OOOOOAA",
            "in OFFBOARD it flies to the newest set-point and reports whose; outside OFFBOARD it ignores them"),
        (GroundStationLost, Ardu, "FFFFFAA", "FS_GCS_ENABLE returns; our own return goes on"),
        (GroundStationLost, Px4, "RRRRRAA",
            "Health Monitoring holds after 10 s; NAV_DLL_ACT after that: its AUTO.LOITER is our mode, with status CRITICAL"),
        (RcLost, Ardu, "FFFFFAA", "FS_THR_ENABLE returns; our own return goes on"),
        (RcLost, Px4, "FFFFRAA",
            "NAV_RCL_ACT: 5 s in AUTO.LOITER, then a return; in our hold the first is our mode, with status CRITICAL"),
        (BatteryLow, null, "RRRRRAA",
            "Health Monitoring: the way home, the reserve and the doubt after a jump of the charge take all of it"),
        (BatteryCritical, Ardu, "RRRRRAA", "Health Monitoring: 8 % reaches home, which is near: it does not land in a field"),
        (BatteryBelowCritical, Px4, "FFFFFFF", "PX4 holds, then returns at 7 %; at 5 %, seconds later, it lands where it is, also out of our return"),
        (VoltageLow, Ardu, "FFFFFAA", "BATT_FS_LOW_ACT returns; our own return goes on"),
        (VoltageCritical, Ardu, "FFFFFLA", "BATT_FS_CRT_ACT lands; LAND is also how a return ends"),
        (BatteryUnknown, null, "AAAAAAA", "an unknown battery is no reason to return: the autopilot's failsafe watches it"),
        (ChargeUnknown, null, "AAAAAAA", "it is reported, and the voltage is judged"),
        (CellVoltageLow, Ardu, "RRRRRAA", "Health Monitoring: return below 3.6 V a cell, whatever the count says"),
        (FixNotReportedShort, null, "AAAAAAA", "Health Monitoring: hold until there is a fix again; a return goes on"),
        (FixNotReported, null, "RRRRRAA", "Health Monitoring: hold, and return after 30 s"),
        (PositionZeroShort, null, "AAAAAAA", "nothing is commanded without a position; after 15 s it would land"),
        (PositionFrozenShort, null, "..AA...", "Health Monitoring: hold until it is right again"),
        (PositionFrozen, null, "..L....", "Health Monitoring: hold, and land after 15 s, as without a position"),
        (PositionJump, null, "..AA...", "Health Monitoring: hold for some seconds"),
        (EstimatorRatioShort, null, "AAAAAAA", "Health Monitoring: hold until it fits again; a return goes on"),
        (EstimatorRatio, null, "RRRRRAA", "Health Monitoring: hold, and return after 30 s"),
        (GpsGlitch, null, "AAAAAAA", "the estimator rejects it"),
        (GpsLostShort, null, "AAAAAAA", "the estimator bridges it"),
        (GpsLost, Ardu, "FFFFFLL",
            "FS_EKF_ACTION lands; LAND is also how a return ends, and without a position where it lands is not known"),
        (GpsLost, Px4, "FFFFFFF", "without a position it descends in AUTO.LAND, which is not how a return ends"),
        (Estimator, Ardu, "FFFFFLL",
            "FS_EKF_ACTION lands; LAND is also how a return ends, and without a valid position where it lands is not known"),
        (Fence, Ardu, "FFFFFAA", "FENCE_ACTION returns; our own return goes on"),
        (Fence, Px4, "FFFFRAA", "GF_ACTION: 5 s in AUTO.LOITER, then a return; in our hold the first is our mode"),
        (Reboot, null, "BBBBBBB", "after a reboot in flight it is no longer our flight"),
        (RebootDisarmed, null, "XXXXXXX", "nothing can be done; it is not reported as landed"),
        (Silent3, Ardu, "AAAAAAA", "too short for anything"),
        (Silent3, Px4, "AFFFAAA", "OFFBOARD is left after COM_OF_LOSS_T: COM_OBL_RC_ACT returns"),
        (Silent20, Ardu, "RRRRRAA", "Health Monitoring: return once the link is back"),
        (Silent20, Px4, "RFFFRAA", "OFFBOARD is left after COM_OF_LOSS_T; else Health Monitoring returns"),
        (Silent400, Ardu, "RRRRRAA", "it waits in GUIDED, and returns once the link is back"),
        (Silent400, Px4, "RDDDRAA",
            "OFFBOARD is left after COM_OF_LOSS_T: it has landed at home when the link is back, no mode shows by what"),
        (MissionControlHangs, null, "RRRRRAA", "Autopilot Interface returns by itself, Mission Control stays with it"),
        (HealthHangs, null, "RRRRRAA", "Mission Control returns without a health report"),
        (AutopilotInterfaceHangs, Ardu, "RRRRRAA", "Health Monitoring: return once it works again"),
        (AutopilotInterfaceHangs, Px4, "RFFFRAA", "OFFBOARD is left after COM_OF_LOSS_T; else Health Monitoring returns"),
        (ImageProcessingHangs, null, "RRRRRAA", "Health Monitoring: a manager hangs"),
        (SensorFusionHangs, null, "RRRRRAA", "Health Monitoring: a manager hangs"),
        (CommunicationsHangs, Ardu, "RRRRRAA", "Health Monitoring: a manager hangs, and the autopilot is lost"),
        (CommunicationsHangs, Px4, "RFFFRAA", "OFFBOARD is left after COM_OF_LOSS_T; else Health Monitoring returns"),
        (CameraSilent, null, "RRRRRAA", "Health Monitoring: a search without pictures"),
        (PicturesBlack, null, "RRRRRAA", "Health Monitoring: holds, then returns after 20 s without usable pictures"),
        (PicturesBlackShort, null, "AAAAAAA", "it holds for that long, and what was not seen is flown again"),
        (PicturesWhite, null, "RRRRRAA", "as black pictures"),
        (PicturesFrozen, null, "RRRRRAA", "the same picture although the ground has moved on"),
        (PicturesDefocused, null, "..RRRAA", "less detail than before; from the first picture on it is not known"),
        (PicturesCovered, null, "RRRRRAA", "half of each picture shows nothing but noise"),
        (PicturesMotionBlurred, null, "..RRRAA", "less detail in one direction than before"),
        (PictureNumbersRepeat, null, "RRRRRAA", "a picture with the number of the one before is not searched"),
        (PictureTimesOff, null, "RRRRRAA", "no pose for the time of a picture"),
        (CameraClockLate, null, "RRR..AA", "the passes over the targets show it: Health Monitoring above 0.3 s"),
        (CameraClockEarly, null, "RRR..AA", "the passes over the targets show it: Health Monitoring above 0.3 s"),
        (CameraClockLittle, null, "AAAAAAA", "a warning: 0.5 m at the speed of the search"),
        (TimesyncWrong, null, "AAAAAAA", "one answer that contradicts the others is put aside"),
        (LinkDelayed, null, "AAAAAAA", "poses by the clock of TIMESYNC stay right: the answers without the delay count"),
        (AttitudeSilent, null, "RRRRRAA", "no pose for the time of a picture"),
        (WindHigh, null, "RRRRRAA", "Health Monitoring: wind above 12 m/s"),
        (Gust, null, "RRRRRAA", "Health Monitoring: gusts above 17 m/s"),
        (ComputerTooHot, null, "RRRRRAA", "Health Monitoring: 84 degrees or more"),
        (ComputerWarm, null, "AAAAAAA", "a warning"),
        (UnderVoltage, null, "AAAAAAA", "a warning: the autopilot's failsafe is there for a computer that fails"),
        (DiskLow, null, "AAAAAAA", "a warning: a flight does not need the disk"),
        (GroundStationHidden, null, "RRRRRAA", "Health Monitoring: hold after 10 s, return after 30 s"),
        (GroundStationHidden20, null, "AAAAAAA", "Health Monitoring: hold after 10 s, until it is back"),
        (ManagerThrows, null, "RRRRRAA", "Health Monitoring: a manager faulted"),
        (Stop, null, "HHHHHKK", "Mission Control holds before the program ends; return and landing go on without us"),
        (BatteryCritical, Px4, "RFFFRFA",
            "8 % reaches home; where it is not down within 45 s it falls below 7 %, and COM_LOW_BAT_ACT 3 takes over: it returns too, also out of our return"),
        (BatteryAged, null, "RRRRRAA", "the voltage shows what the percentage does not: return"),
    ];

    // Not right yet, each with the reason. A cell that ends as expected has to be taken out.
    private static readonly (MatrixFault Fault, SimulatedAutopilot Model, MissionPhase[] Phases, string Why)[] Known =
        [];

    /// <summary>All of them.</summary>
    public static IReadOnlyList<FaultCell> All { get; } = Rows.SelectMany(Expand).ToArray();

    /// <summary>Those that are decided within 60 s from the start of the run; all with one seed.</summary>
    public static IEnumerable<FaultCell> Short => All.Where(IsShort).Select(c => c with { Seed = Seeds[0] });

    private static bool IsShort(FaultCell cell)
    {
        MatrixFault fault = cell.Fault;
        return cell.Phase switch
        {
            MissionPhase.TakingOff => fault == PilotHold || fault == PilotPosition || fault == PilotReturn
                || fault == RebootDisarmed || fault == Stop || fault == Fence,
            MissionPhase.InTransit => fault == PilotHold || fault == PilotPosition || fault == PilotReturn
                || fault == PilotLand || fault == OtherReposition || fault == GroundStationLost || fault == RcLost
                || fault == Reboot || fault == Stop,
            MissionPhase.Searching => fault == PilotHold,
            _ => false,
        };
    }

    private static IEnumerable<FaultCell> Expand(
        (MatrixFault Fault, SimulatedAutopilot? Model, string Ends, string Reason) row, int index)
    {
        foreach (SimulatedAutopilot model in row.Model is { } one ? [one] : new[] { Ardu, Px4 })
        {
            for (int phase = 0; phase < Phases.Length; phase++)
            {
                if (row.Ends[phase] != '.')
                    yield return new FaultCell(
                        row.Fault, Phases[phase], model, Letters[row.Ends[phase]], row.Reason,
                        Seeds[index % Seeds.Length])
                    { Known = WhyKnown(row.Fault, model, Phases[phase]) };
            }
        }
    }

    private static string? WhyKnown(MatrixFault fault, SimulatedAutopilot model, MissionPhase phase)
        => Known.Where(k => k.Fault == fault && k.Model == model && k.Phases.Contains(phase)).Select(k => k.Why)
            .FirstOrDefault();
}
