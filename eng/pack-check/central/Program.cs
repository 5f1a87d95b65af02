using System;
using Acme.Farm;
using Acme.Orchard;
using Central.Messages;
using Rabit.Mavlink.Messages;

// Two dialects that add to one enum of the package: both give values of the same type.
MavCmd[] commands = [FarmMavCmd.TractorStop, OrchardMavCmd.LadderStop];
var tractor = new Tractor { Height = 2.5f, LastCommand = commands[0] };
var ladder = new Ladder { Height = 4, LastCommand = commands[1] };
Console.WriteLine(
    $"{tractor.Height} {ladder.Height} {new Basket { Apples = 3 }.Apples} {(int)commands[0]} {(int)commands[1]}");
Console.WriteLine(
    string.Join(" ", FarmDialect.Instance.Name, OrchardDialect.Instance.Name, PlainDialect.Instance.Name));
