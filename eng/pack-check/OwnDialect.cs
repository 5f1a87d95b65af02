using System;
using System.Linq;
using System.Text;
using Harvest.Wire;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace PackCheck
{
    /// <summary>
    /// What the generator in the package made of dialects/orchard.xml, which includes company.xml, which includes
    /// common.xml of the package.
    /// </summary>
    internal static class OwnDialect
    {
        public static void Check()
        {
            MavlinkDialect orchard = OrchardDialect.Instance;
            Require(OrchardFruit.MavlinkId == 70001 && CompanyState.MavlinkId == 70000, "ids above 65535");
            Require(
                OrchardFruit.MavlinkMinLength == 51 && OrchardFruit.MavlinkMaxLength == 53,
                "an extension behind the other fields");
            Require(
                orchard.Count == MavlinkDialect.Common.Count + 2 && orchard.Name == "orchard", "two include levels");

            // Only what the package does not have is made here.
            Type[] own = typeof(OwnDialect).Assembly.GetTypes()
                .Where(type => type.Namespace == "Harvest.Wire" && type.IsPublic).ToArray();
            Require(
                string.Join(" ", own.Select(type => type.Name).OrderBy(name => name, StringComparer.Ordinal))
                    == "CompanyMode CompanyState OrchardDialect OrchardFruit OrchardFruitFlags OrchardMavCmd Text12",
                "nothing twice, but: " + string.Join(" ", own.Select(type => type.Name)));
            Require(typeof(OrchardFruitFlags).IsDefined(typeof(FlagsAttribute), false), "[Flags]");
            Require(
                (int)OrchardMavCmd.OrchardPick == 48100 && (int)OrchardMavCmd.CompanyRest == 48000,
                "entries added to an enum of the package");
            MavState status = default(CompanyState).Status;
            Require(status == MavState.Uninit, "the enums of the package");

            var fruit = new OrchardFruit
            {
                Number = 7,
                Position = new FloatArray3(new[] { 0.5f, float.NaN, -0f }),
                Spectrum = new UInt16Array5(new ushort[] { 1, 2, 3, 4, 65535 }),
                Flags = OrchardFruitFlags.Ripe | OrchardFruitFlags.BehindLeaves,
                Variety = new Text12("Boskoop"),
                Temperature = -1,
            };
            Program.PassOn(new Heartbeat { Type = MavType.Quadrotor }, orchard);
            Program.PassOn(
                new CompanyState { LastCommand = OrchardMavCmd.OrchardPick, Mode = CompanyMode.Picking }, orchard);
            MavlinkFrame frame = Program.PassOn(
                fruit, MavlinkDialect.Combine("both", MavlinkDialect.ArduPilotMega, orchard));
            Print(orchard, frame);
            var command = new CommandLong { Command = OrchardMavCmd.OrchardPick };
            Print(orchard, Program.PassOn(command, orchard));
        }

        private static void Print(MavlinkDialect dialect, MavlinkFrame frame)
        {
            var text = new StringBuilder();
            dialect.FindDefinition(frame.MessageId).AppendTo(text, frame);
            Console.WriteLine(text);
        }

        private static void Require(bool holds, string what)
        {
            if (!holds)
                throw new InvalidOperationException("The dialect of this program does not have " + what + ".");
        }
    }
}
